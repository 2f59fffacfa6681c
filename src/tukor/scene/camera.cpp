#include "tukor/scene/camera.h"

#include <cmath>

namespace tukor {

CameraAxes axesOf(const Camera& camera) noexcept {
    CameraAxes axes{};
    axes.forward = glm::normalize(camera.target - camera.eye);
    glm::vec3 right = glm::cross(axes.forward, camera.up);
    if (glm::dot(right, right) <
        1e-12f * glm::dot(camera.up, camera.up)) {  // up along the view, to 1e-6 rad
        const glm::vec3 other =
            std::abs(axes.forward.y) > 0.5f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
        right = glm::cross(axes.forward, other);
    }
    axes.right = glm::normalize(right);
    axes.up = glm::cross(axes.right, axes.forward);
    return axes;
}

glm::vec3 rayDirection(const Camera& camera, int width, int height, float x, float y) noexcept {
    const CameraAxes axes = axesOf(camera);
    const float halfHeight = std::tan(0.5f * camera.verticalFov);
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const float u = 2.0f * x / static_cast<float>(width) - 1.0f;
    const float v = 1.0f - 2.0f * y / static_cast<float>(height);
    return axes.forward + (u * aspect * halfHeight) * axes.right + (v * halfHeight) * axes.up;
}

}  // namespace tukor
