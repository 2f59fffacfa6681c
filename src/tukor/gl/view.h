// The matrices of a camera: from the world to the screen, and the lecture's rayDirMatrix back.
#pragma once
#include <glm/glm.hpp>

#include "tukor/geometry/mesh.h"
#include "tukor/scene/camera.h"

namespace tukor::gl {

/// Column vectors: clip = clipFromWorld * world.
struct View {
    glm::mat4 clipFromWorld;
    /// (P V E)^-1, E the translation by the eye: the lecture's (E V P)^-1 for row vectors. Its xyz
    /// is the ray's direction without a divide: w is the same positive number all over the quad.
    glm::mat4 rayDirMatrix;
    glm::vec3 eye;
};

/// A rectangle of a picture of fullWidth x fullHeight pixels; `left` and `bottom` count from its
/// bottom-left corner.
struct PictureWindow {
    int fullWidth;
    int fullHeight;
    int left;
    int bottom;
    int width;
    int height;

    friend bool operator==(const PictureWindow&, const PictureWindow&) = default;
};

/// `jitter` moves the picture's sampling points, in pixels, x right and y up. The depth range holds
/// `bounds`, as far as it lies in front of the eye.
[[nodiscard]] View viewOf(const Camera& camera, const PictureWindow& window, glm::vec2 jitter,
                          const Bounds& bounds) noexcept;

/// The i-th of `count` points that fill the square [-0.5, 0.5)^2 evenly and average to its centre.
[[nodiscard]] glm::vec2 evenPoint(int i, int count) noexcept;

/// The i-th of a sequence of such points without an end; the first is the centre.
[[nodiscard]] glm::vec2 evenPoint(int i) noexcept;

}  // namespace tukor::gl
