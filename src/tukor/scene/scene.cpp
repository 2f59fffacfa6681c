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
    constexpr float kMargin = 1.15f;  // air around what is looked at
    const Bounds bounds = boundsOf(scene);
    Camera camera;
    if (bounds.empty()) return camera;
    camera.target = bounds.centre();
    camera.eye = camera.target + glm::normalize(glm::vec3(0.0f, 0.25f, 1.0f));
    const CameraAxes axes = axesOf(camera);
    const float vertical = std::tan(0.5f * camera.verticalFov) / kMargin;
    const float horizontal = aspect * vertical;
    float distance = 0.0f;  // the least from which every vertex is in the picture
    for (const Part& part : scene.parts)
        for (const glm::vec3 position : part.mesh.positions) {
            const glm::vec3 p = position - camera.target;
            const float sideways = std::abs(glm::dot(p, axes.right)) / horizontal;
            const float upwards = std::abs(glm::dot(p, axes.up)) / vertical;
            distance = std::max(distance, std::max(sideways, upwards) - glm::dot(p, axes.forward));
        }
    // Not inside of flat things seen edge on, nor too near for floats.
    distance = std::max({distance, 1.01f * bounds.radius(), 1e-6f});
    camera.eye = camera.target - distance * axes.forward;
    return camera;
}

}  // namespace tukor
