#include "tukor/gl/view.h"

#include <gtest/gtest.h>

namespace tukor::gl {
namespace {

Camera someCamera() {
    Camera camera;
    camera.eye = {1.0f, 2.0f, 3.0f};
    camera.target = {-0.5f, 0.25f, -1.0f};
    camera.verticalFov = 0.9f;
    return camera;
}

Bounds unitBox() {
    Bounds bounds;
    bounds.include(glm::vec3(-1.0f));
    bounds.include(glm::vec3(1.0f));
    return bounds;
}

TEST(View, RayDirMatrixGivesTheRayOfEveryPixelOfEveryWindow) {
    const Camera camera = someCamera();
    const PictureWindow windows[] = {{64, 36, 0, 0, 64, 36}, {64, 36, 16, 10, 24, 20}};
    for (const PictureWindow& window : windows) {
        for (const glm::vec2 jitter : {glm::vec2(0.0f), glm::vec2(0.25f, -0.375f)}) {
            const View view = viewOf(camera, window, jitter, unitBox());
            for (int row = 0; row < window.height; row += 3) {
                for (int column = 0; column < window.width; column += 5) {
                    const glm::vec2 fragment = glm::vec2(column, row) + 0.5f;
                    const glm::vec2 ndc =
                        2.0f * fragment / glm::vec2(window.width, window.height) - 1.0f;
                    const glm::vec4 ray = view.rayDirMatrix * glm::vec4(ndc, 0.999f, 1.0f);
                    EXPECT_GT(ray.w, 0.0f);
                    const glm::vec2 place =
                        glm::vec2(window.left, window.bottom) + fragment + jitter;
                    const glm::vec3 expected = glm::normalize(
                        rayDirection(camera, window.fullWidth, window.fullHeight, place.x,
                                     static_cast<float>(window.fullHeight) - place.y));
                    EXPECT_LT(glm::length(glm::normalize(glm::vec3(ray)) - expected), 2e-6f);

                    // And the way back: a point on the ray falls on the fragment.
                    const glm::vec4 clip =
                        view.clipFromWorld * glm::vec4(camera.eye + 3.0f * expected, 1.0f);
                    EXPECT_LT(glm::length(glm::vec2(clip) / clip.w - ndc), 1e-5f);
                }
            }
        }
    }
}

TEST(EvenPoint, StaysInTheSquareAndAveragesToItsCentre) {
    for (const int count : {1, 2, 3, 4, 16, 25, 64}) {
        glm::vec2 sum(0.0f);
        for (int i = 0; i < count; ++i) {
            const glm::vec2 point = evenPoint(i, count);
            EXPECT_LE(glm::max(std::abs(point.x), std::abs(point.y)), 0.5f);
            sum += point;
        }
        EXPECT_LT(glm::length(sum), 1e-5f * static_cast<float>(count)) << count;
    }
    glm::vec2 sum(0.0f);
    for (int i = 0; i < 65; ++i) sum += evenPoint(i);
    EXPECT_LT(glm::length(sum), 1e-3f);
}

/// The largest difference between a corner box's area and its share of the points.
template <class Point>
float discrepancy(int count, Point&& point) {
    float worst = 0.0f;
    for (int i = 1; i <= 16; ++i) {
        for (int j = 1; j <= 16; ++j) {
            const float right = static_cast<float>(i) / 16.0f - 0.5f;
            const float top = static_cast<float>(j) / 16.0f - 0.5f;
            int inside = 0;
            for (int k = 0; k < count; ++k) {
                const glm::vec2 p = point(k);
                inside += p.x < right && p.y < top ? 1 : 0;
            }
            const float share = static_cast<float>(inside) / static_cast<float>(count);
            worst = std::max(worst, std::abs(share - (right + 0.5f) * (top + 0.5f)));
        }
    }
    return worst;
}

TEST(EvenPoint, FillsTheSquareEvenly) {
    // Random points: about 0.13 at 64.
    EXPECT_LT(discrepancy(64, [](int i) { return evenPoint(i, 64); }), 0.05f);
    EXPECT_LT(discrepancy(64, [](int i) { return evenPoint(i); }), 0.05f);
}

}  // namespace
}  // namespace tukor::gl
