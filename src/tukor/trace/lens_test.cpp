#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tukor/trace/render.h"
#include "tukor/trace/sampler.h"
#include "tukor/trace/test_scenes.h"

namespace tukor::trace {
namespace {

constexpr int kWidth = 48, kHeight = 32;
constexpr float kDistance = 4.0f;  // of the eye from the plane z = 0, along -Z

Camera withLens(float diameter, float focus) {
    Camera camera = eyeAt({0, 0, kDistance});
    camera.lensDiameter = diameter;
    camera.focus = focus;
    return camera;
}

RenderOptions options(int samples) {
    RenderOptions o;
    o.width = kWidth;
    o.height = kHeight;
    o.samples = samples;
    return o;
}

/// How much of a disc of that radius lies beyond `x` of its middle.
double beyond(double x, double radius) {
    if (radius <= 0.0) return x < 0.0 ? 1.0 : 0.0;
    const double t = std::clamp(x / radius, -1.0, 1.0);
    return (std::acos(t) - t * std::sqrt(1.0 - t * t)) / std::numbers::pi;
}

/// The same on the mean over a pixel of the middle row, whose disc lies about where it looks, on a
/// plane at `distance`; beyond x = 0.
double seenBeyondMiddle(int column, double distance, double radius) {
    constexpr int kParts = 64;
    const double pixel = 2.0 * distance * std::tan(0.5 * Camera{}.verticalFov) / kHeight;
    double sum = 0.0;
    for (int i = 0; i < kParts; ++i)
        sum += beyond(-pixel * (column - kWidth / 2 + (i + 0.5) / kParts), radius);
    return sum / kParts;
}

/// Light from the right, +X, alone.
Image halfLit() {
    Image panorama(1024, 512);
    for (int row = 0; row < panorama.height(); ++row)
        for (int column = 512; column < 1024; ++column) panorama.at(column, row) = glm::vec3(1.0f);
    return panorama;
}

TEST(Lens, IsADiscEvenlyCovered) {
    constexpr int kAcross = 64;
    int inside = 0;  // half the radius: a quarter of them
    for (int i = 0; i < kAcross * kAcross; ++i) {
        const glm::vec2 at = onLens((glm::vec2(i % kAcross, i / kAcross) + 0.5f) / 64.0f);
        ASSERT_LE(glm::length(at), 1.0f);
        inside += glm::length(at) < 0.5f;
    }
    EXPECT_EQ(inside, kAcross * kAcross / 4);
    EXPECT_EQ(onLens({0.5f, 0.5f}), glm::vec2(0.0f));
    EXPECT_NEAR(onLens({0.999999f, 0.5f}).x, 1.0f, 1e-5f);
    EXPECT_NEAR(onLens({0.5f, 0.0f}).y, -1.0f, 1e-5f);
}

TEST(Lens, BlursAnEdgeOutOfFocusAsItsClosedForm) {
    Scene scene;
    scene.parts.push_back({"", "", metal(), boxMesh({0, -10, -1e-3f}, {10, 10, 0})});
    RenderOptions o = options(1024);
    o.background = Background::none;
    constexpr float kRadius = 0.2f;
    for (const float focus : {2.0f, 4.0f, 8.0f}) {  // before the edge, on it, beyond
        const Rendering r = render(scene, constantCube(1.0f), withLens(2 * kRadius, focus), o);
        const double blurred = kRadius * std::abs(kDistance - focus) / focus;
        for (int column = 16; column < 32; ++column) {
            const float alpha =
                r.radiance.alpha[static_cast<std::size_t>(kHeight / 2 * kWidth + column)];
            EXPECT_NEAR(alpha, seenBeyondMiddle(column, kDistance, blurred), 0.01)
                << "column " << column << ", focus " << focus;
        }
    }
}

TEST(Lens, FocusesOnTheTargetUnlessTold) {
    Scene scene;
    scene.parts.push_back({"", "", metal(), boxMesh({0, -10, -1e-3f}, {10, 10, 0})});
    RenderOptions o = options(64);
    o.background = Background::none;
    const Rendering r = render(scene, constantCube(1.0f), withLens(0.4f, 0.0f), o);
    EXPECT_EQ(r.radiance.alpha[kHeight / 2 * kWidth + 22], 0.0f);
    EXPECT_EQ(r.radiance.alpha[kHeight / 2 * kWidth + 25], 1.0f);
}

TEST(Lens, BlursTheEnvironmentAsItsClosedForm) {
    constexpr float kRadius = 0.2f, kFocus = 2.0f;
    for (const int samples : {64, 1024}) {  // the fewer, the wider is each
        const Rendering r =
            render(Scene{}, halfLit(), withLens(2 * kRadius, kFocus), options(samples));
        for (int column = 16; column < 32; ++column) {
            EXPECT_NEAR(r.radiance.at(column, kHeight / 2).x,
                        seenBeyondMiddle(column, 1.0, kRadius / kFocus), 0.03)
                << "column " << column << ", " << samples << " samples";
        }
    }
}

TEST(Lens, LosesNoLight) {
    const Scene scene = sceneOfShape("torus-knot", clear(1.5f, 1));
    Camera camera = withLens(0.5f, 2.0f);
    camera.eye = {0.5f, 1.0f, 3.5f};
    const Rendering r = render(scene, constantCube(1.0f), camera, options(16));
    for (const glm::vec3& pixel : r.radiance.pixels()) ASSERT_NEAR(pixel.x, 1.0f, 1e-5f);
    EXPECT_EQ(r.leaks, 0u);
    EXPECT_EQ(r.inconsistencies, 0u);
}

TEST(Lens, ReportsAnErrorThatIsTrue) {
    const Scene scene = sceneOfShape("torus-knot", metal());
    const Camera camera = withLens(0.4f, 2.5f);
    const Rendering truth = render(scene, gradientCube(), camera, options(4096));
    RenderOptions o = options(1);
    o.samples.reset();
    o.error = 2.0f;
    const Rendering r = render(scene, gradientCube(), camera, o);
    ASSERT_TRUE(r.error);
    const double error = rmse8(r.radiance, truth.radiance);
    EXPECT_LT(error / *r.error, 1.5);
    EXPECT_GT(error / *r.error, 1.0 / 1.5);
}

}  // namespace
}  // namespace tukor::trace
