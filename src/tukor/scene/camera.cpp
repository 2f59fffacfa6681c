#include "tukor/scene/camera.h"

#include <algorithm>
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

ClipPlanes clipPlanesFor(const Camera& camera, const Bounds& bounds) noexcept {
    if (bounds.empty()) return {};
    const glm::vec3 forward = axesOf(camera).forward;
    const float depth = glm::dot(bounds.centre() - camera.eye, forward);
    const glm::vec3 half = 0.5f * (bounds.most - bounds.least);
    const float reach = glm::dot(half, glm::abs(forward));
    const float slack = 1e-3f * reach + 1e-6f * std::abs(depth);  // rounding of what is drawn
    ClipPlanes planes;
    planes.farDistance = std::max(depth + reach + slack, 1e-6f);  // all behind: nothing to see
    planes.nearDistance = std::max(depth - reach - slack, 1e-4f * planes.farDistance);
    if (!(planes.nearDistance < planes.farDistance))  // a point or a flat plate seen from afar
        planes.nearDistance = 0.5f * planes.farDistance;
    return planes;
}

bool liesBeyondNearPlane(const Camera& camera, const Bounds& bounds) noexcept {
    const glm::vec3 forward = axesOf(camera).forward;
    const glm::vec3 half = 0.5f * (bounds.most - bounds.least);
    const float nearest =
        glm::dot(bounds.centre() - camera.eye, forward) - glm::dot(half, glm::abs(forward));
    return nearest > clipPlanesFor(camera, bounds).nearDistance;
}

glm::mat4 cameraFromWorld(const Camera& camera) noexcept {
    const CameraAxes axes = axesOf(camera);
    glm::mat4 matrix(1.0f);
    for (int i = 0; i < 3; ++i)
        matrix[i] = glm::vec4(axes.right[i], axes.up[i], -axes.forward[i], 0.0f);
    matrix[3] = glm::vec4(-glm::dot(axes.right, camera.eye), -glm::dot(axes.up, camera.eye),
                          glm::dot(axes.forward, camera.eye), 1.0f);
    return matrix;
}

glm::mat4 clipFromCamera(const Camera& camera, float aspect, const ClipPlanes& planes) noexcept {
    const float halfHeight = std::tan(0.5f * camera.verticalFov);
    const float n = planes.nearDistance, f = planes.farDistance;
    glm::mat4 matrix(0.0f);
    matrix[0][0] = 1.0f / (aspect * halfHeight);
    matrix[1][1] = 1.0f / halfHeight;
    matrix[2][2] = -(f + n) / (f - n);
    matrix[2][3] = -1.0f;
    matrix[3][2] = -2.0f * f * n / (f - n);
    return matrix;
}

glm::mat4 rayDirMatrix(const Camera& camera, float aspect, const ClipPlanes& planes) noexcept {
    // V E has the camera's axes as rows: its inverse is the transpose. P inverts by hand.
    const CameraAxes axes = axesOf(camera);
    const float halfHeight = std::tan(0.5f * camera.verticalFov);
    const float n = planes.nearDistance, f = planes.farDistance;
    glm::mat4 matrix(0.0f);
    matrix[0] = glm::vec4((aspect * halfHeight) * axes.right, 0.0f);
    matrix[1] = glm::vec4(halfHeight * axes.up, 0.0f);
    matrix[2] = glm::vec4(0.0f, 0.0f, 0.0f, -0.5f * (f - n) / (f * n));
    matrix[3] = glm::vec4(axes.forward, 0.5f * (f + n) / (f * n));
    return matrix;
}

}  // namespace tukor
