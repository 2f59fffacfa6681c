#include "tukor/scene/orbit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tukor {

Camera orbit(const Camera& camera, float yaw, float pitch) noexcept {
    constexpr float kPoleGap = std::numbers::pi_v<float> / 360.0f;  // half a degree
    constexpr float kSteepest = 0.5f * std::numbers::pi_v<float> - kPoleGap;
    const glm::vec3 offset = camera.eye - camera.target;
    const float distance = glm::length(offset);
    const glm::vec3 up = glm::normalize(camera.up);
    // From above or below, where `offset` has no heading, the camera's own axes give one.
    const CameraAxes axes = axesOf(camera);
    const glm::vec3 back = glm::normalize(glm::cross(axes.right, up));
    const glm::vec3 right = glm::cross(up, back);

    const float sine = std::clamp(glm::dot(offset, up) / distance, -1.0f, 1.0f);
    const float elevation = std::clamp(std::asin(sine) + pitch, -kSteepest, kSteepest);
    const glm::vec3 heading = std::cos(yaw) * back + std::sin(yaw) * right;
    Camera moved = camera;
    moved.eye =
        camera.target + distance * (std::cos(elevation) * heading + std::sin(elevation) * up);
    return moved;
}

Camera pan(const Camera& camera, float right, float up) noexcept {
    const CameraAxes axes = axesOf(camera);
    const float height = 2.0f * std::tan(0.5f * camera.verticalFov) *
                         glm::length(camera.target - camera.eye);  // of the picture, in metres
    const glm::vec3 shift = height * (right * axes.right + up * axes.up);
    Camera moved = camera;
    moved.eye -= shift;
    moved.target -= shift;
    return moved;
}

Camera dolly(const Camera& camera, float factor) noexcept {
    // Nearer than this, floats no longer tell the eye from the target.
    const float least = 1e-4f * (glm::length(camera.target) + 1e-3f);
    const glm::vec3 offset = camera.eye - camera.target;
    const float distance = glm::length(offset);
    Camera moved = camera;
    moved.eye = camera.target + (std::max(distance * factor, least) / distance) * offset;
    return moved;
}

Camera focus(const Camera& camera, glm::vec3 point) noexcept {
    Camera moved = camera;
    moved.eye += point - camera.target;
    moved.target = point;
    return moved;
}

}  // namespace tukor
