// Pinhole cameras, and the matrices of the lecture's rows 18 and 19.
#pragma once
#include <glm/glm.hpp>

namespace tukor {

/// Looks from `eye` to `target`; metres. The picture's up is `up` as seen from there.
struct Camera {
    glm::vec3 eye{0.0f, 0.0f, 4.0f};
    glm::vec3 target{0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    float verticalFov = 0.69813170f;  // radians; 40 degrees
};

/// Orthonormal axes of a camera in the world: right, up, and forward to the target.
struct CameraAxes {
    glm::vec3 right;
    glm::vec3 up;
    glm::vec3 forward;
};

/// Well defined for every camera with eye != target: where `up` is parallel to the view, another up
/// is chosen.
[[nodiscard]] CameraAxes axesOf(const Camera& camera) noexcept;

/// World direction, not normalised, through the pixel position (x, y) measured from the top-left
/// corner, in pixels.
[[nodiscard]] glm::vec3 rayDirection(const Camera& camera, int width, int height, float x,
                                     float y) noexcept;

}  // namespace tukor
