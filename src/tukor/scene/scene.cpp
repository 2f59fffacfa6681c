#include "tukor/scene/scene.h"

#include <algorithm>
#include <cmath>

namespace tukor {

Bounds boundsOf(const Scene& scene) noexcept {
    Bounds bounds;
    for (const Part& part : scene.parts) {
        const Bounds one = boundsOf(part.mesh);
        if (one.empty()) continue;
        bounds.include(one.least);
        bounds.include(one.most);
    }
    return bounds;
}

Camera framingCamera(const Scene& scene, float aspect) noexcept {
    const Bounds bounds = boundsOf(scene);
    Camera camera;
    if (bounds.empty()) return camera;
    const float radius = std::max(bounds.radius(), 1e-6f);
    // The bounding sphere just fits the narrower of the two fields of view.
    const float halfVertical = 0.5f * camera.verticalFov;
    const float halfHorizontal = std::atan(std::tan(halfVertical) * aspect);
    const float distance = radius / std::sin(std::min(halfVertical, halfHorizontal));
    camera.target = bounds.centre();
    camera.eye = camera.target + distance * glm::normalize(glm::vec3(0.0f, 0.25f, 1.0f));
    return camera;
}

}  // namespace tukor
