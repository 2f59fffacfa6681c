#include "tukor/gl/view.h"

#include <cmath>

namespace tukor::gl {

View viewOf(const Camera& camera, const PictureWindow& window, glm::vec2 jitter,
            const Bounds& bounds) noexcept {
    const glm::vec2 full(window.fullWidth, window.fullHeight);
    const glm::vec2 size(window.width, window.height);
    const glm::vec2 corner(window.left, window.bottom);
    const float aspect = full.x / full.y;
    const ClipPlanes planes = clipPlanesFor(camera, bounds);

    // The fragment at a pixel's centre sees what lies `jitter` beside it; the window's middle is
    // `offset` pixels off the picture's.
    const glm::vec2 offset = corner + 0.5f * size - 0.5f * full + jitter;
    const glm::vec2 scale = full / size;
    const glm::vec2 shift = -2.0f * offset / size;
    glm::mat4 windowFromPicture(1.0f);
    windowFromPicture[0][0] = scale.x;
    windowFromPicture[1][1] = scale.y;
    windowFromPicture[3][0] = shift.x;
    windowFromPicture[3][1] = shift.y;
    glm::mat4 pictureFromWindow(1.0f);
    pictureFromWindow[0][0] = 1.0f / scale.x;
    pictureFromWindow[1][1] = 1.0f / scale.y;
    pictureFromWindow[3][0] = -shift.x / scale.x;
    pictureFromWindow[3][1] = -shift.y / scale.y;

    View view{};
    view.clipFromWorld =
        windowFromPicture * clipFromCamera(camera, aspect, planes) * cameraFromWorld(camera);
    view.rayDirMatrix = rayDirMatrix(camera, aspect, planes) * pictureFromWindow;
    view.eye = camera.eye;
    return view;
}

namespace {

/// The distance to the nearest integer, with its sign.
float wrapped(double x) {
    return static_cast<float>(x - std::floor(x + 0.5));
}

}  // namespace

glm::vec2 evenPoint(int i, int count) noexcept {
    // A lattice of the golden ratio, point-symmetric about the centre.
    const double place = i - 0.5 * (count - 1);
    return {wrapped(place / count), wrapped(place * 0.6180339887498949)};
}

glm::vec2 evenPoint(int i) noexcept {
    // The R2 sequence, steps of powers of the inverse of x^3 = x + 1; in pairs about the centre, so
    // that every odd number of points averages to it. [Roberts 2018]
    const int pair = (i + 1) / 2;
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    return {wrapped(side * pair * 0.7548776662466927), wrapped(side * pair * 0.5698402909980532)};
}

}  // namespace tukor::gl
