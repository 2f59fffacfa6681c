#include "tukor/scene/orbit.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace tukor {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

void expectNear(glm::vec3 actual, glm::vec3 expected, float tolerance = 1e-5f) {
    EXPECT_LT(glm::length(actual - expected), tolerance)
        << actual.x << ' ' << actual.y << ' ' << actual.z << " instead of " << expected.x << ' '
        << expected.y << ' ' << expected.z;
}

TEST(Orbit, YawToTheRightTurnsTheEyeTowardsPlusX) {
    expectNear(orbit(Camera{}, 0.5f * kPi, 0.0f).eye, {4, 0, 0});
}

TEST(Orbit, PitchRaisesTheEye) {
    expectNear(orbit(Camera{}, 0.0f, kPi / 6.0f).eye, {0, 2, 2 * std::sqrt(3.0f)});
}

TEST(Orbit, KeepsTheDistanceAndTheTarget) {
    Camera camera{.eye = {1, 2, 3}, .target = {0.5f, -1, 0}};
    const float distance = glm::length(camera.eye - camera.target);
    for (int i = 0; i < 1000; ++i) camera = orbit(camera, 0.1f, 0.05f);
    EXPECT_NEAR(glm::length(camera.eye - camera.target), distance, 1e-3f);
    EXPECT_EQ(camera.target, glm::vec3(0.5f, -1, 0));
}

TEST(Orbit, ThereAndBackIsTheSamePlace) {
    const Camera camera{.eye = {1, 2, 3}, .target = {0.5f, -1, 0}};
    expectNear(orbit(orbit(camera, 0.7f, -0.4f), -0.7f, 0.4f).eye, camera.eye);
}

TEST(Orbit, StopsShortOfThePoleAndKeepsItsHeading) {
    const Camera top = orbit(orbit(Camera{}, 0.3f, 0.0f), 0.0f, 10.0f);
    EXPECT_GT(top.eye.y, 3.999f);
    EXPECT_GT(glm::length(glm::vec2(top.eye.x, top.eye.z)), 0.03f);
    expectNear(orbit(top, 0.0f, 0.5f - kPi / 2.0f + kPi / 360.0f).eye,
               orbit(Camera{}, 0.3f, 0.5f).eye, 1e-3f);
}

TEST(Orbit, MovesFromExactlyAbove) {
    Camera camera;
    camera.eye = {0, 4, 0};
    const Camera moved = orbit(camera, 0.1f, -0.2f);
    EXPECT_NEAR(glm::length(moved.eye), 4.0f, 1e-5f);
    EXPECT_LT(moved.eye.y, 4.0f);
}

TEST(Pan, MovesThePictureByTheFractionAsked) {
    const Camera camera{.eye = {1, 2, 3}, .target = {0.5f, -1, 0}};
    const Camera moved = pan(camera, 0.25f, -0.1f);
    const glm::vec4 clip = clipFromCamera(moved, 1.0f) * cameraFromWorld(moved) *
                           glm::vec4(camera.target, 1.0f);  // NDC spans two heights
    EXPECT_NEAR(clip.x / clip.w, 0.5f, 1e-5f);
    EXPECT_NEAR(clip.y / clip.w, -0.2f, 1e-5f);
    expectNear(moved.eye - moved.target, camera.eye - camera.target);
}

TEST(Dolly, ScalesTheDistanceButNeverToNothing) {
    expectNear(dolly(Camera{}, 0.5f).eye, {0, 0, 2});
    Camera camera;
    for (int i = 0; i < 200; ++i) camera = dolly(camera, 0.5f);
    EXPECT_GT(camera.eye.z, 0.0f);
    EXPECT_TRUE(std::isfinite(rayDirection(camera, 4, 4, 1.0f, 1.0f).x));
}

TEST(Focus, BringsThePointToTheMiddle) {
    const Camera camera{.eye = {1, 2, 3}, .target = {0.5f, -1, 0}};
    const glm::vec3 point{0.2f, 0.3f, -0.4f};
    const Camera moved = focus(camera, point);
    expectNear(moved.target, point);
    expectNear(axesOf(moved).forward, axesOf(camera).forward);
}

}  // namespace
}  // namespace tukor
