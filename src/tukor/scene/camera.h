// Cameras, and the matrices of the lecture's rows 18 and 19.
#pragma once
#include <glm/glm.hpp>

#include "tukor/geometry/mesh.h"

namespace tukor {

/// Looks from `eye` to `target`; metres. The picture's up is `up` as seen from there.
struct Camera {
    glm::vec3 eye{0.0f, 0.0f, 4.0f};
    glm::vec3 target{0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    float verticalFov = 0.69813170f;  // radians; 40 degrees
    float lensDiameter = 0.0f;        // metres; 0: a pinhole, of which all pictures are sharp
    float focus = 0.0f;  // metres along the view to the plane of which a lens's are; 0: to `target`

    friend bool operator==(const Camera&, const Camera&) = default;
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

/// Distances from the eye along the view, 0 < nearDistance < farDistance, in metres.
struct ClipPlanes {
    float nearDistance = 0.1f;
    float farDistance = 100.0f;
};

/// Planes that enclose the box from wherever the camera stands, in it included; no farther apart
/// than depth buffers of 24 bits stand (1 : 10,000).
[[nodiscard]] ClipPlanes clipPlanesFor(const Camera& camera, const Bounds& bounds) noexcept;

/// Whether no part of the box is cut off by the nearer of those planes.
[[nodiscard]] bool liesBeyondNearPlane(const Camera& camera, const Bounds& bounds) noexcept;

/// The lecture's V for column vectors: world to camera, which looks down -Z with +Y up.
[[nodiscard]] glm::mat4 cameraFromWorld(const Camera& camera) noexcept;

/// The lecture's P for column vectors: camera to OpenGL's clip space; `aspect` is width over
/// height. Where the picture meets the planes, NDC z is -1 and 1.
[[nodiscard]] glm::mat4 clipFromCamera(const Camera& camera, float aspect,
                                       const ClipPlanes& planes = {}) noexcept;

/// World direction of the ray through a point in NDC: rayDirMatrix * vec4(ndc, 1), read its xyz.
///
/// The lecture multiplies row vectors, d = ndc (E V P)^-1, with E the translation by the eye. For
/// column vectors, as here and in the shaders, that is d = (P V E)^-1 ndc: the transpose of the
/// lecture's matrix. xyz does not depend on NDC z or on the planes and equals rayDirection() at the
/// same point; w is positive all over the picture and only says how far away NDC z lies, so nothing
/// is divided by it: xyz is linear in x and y and may be interpolated over the viewport.
[[nodiscard]] glm::mat4 rayDirMatrix(const Camera& camera, float aspect,
                                     const ClipPlanes& planes = {}) noexcept;

}  // namespace tukor
