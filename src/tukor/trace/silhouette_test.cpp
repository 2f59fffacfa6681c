#include "tukor/trace/silhouette.h"

#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tukor/trace/render.h"
#include "tukor/trace/test_scenes.h"

namespace tukor::trace {
namespace {

constexpr int kWidth = 64, kHeight = 48;

struct Counts {
    int seen = 0;    // pixels in which one of 8 x 8 rays meets a surface
    int drawn = 0;   // pixels of the silhouette
    int missed = 0;  // pixels seen, but not drawn
};

Counts count(const Scene& scene, const Camera& camera) {
    const SurfaceTable surfaces(scene);
    const RayCaster caster(surfaces);
    const RayGenerator rays(camera, kWidth, kHeight);
    const std::vector<std::uint8_t> mask = silhouetteOf(surfaces, rays, kWidth, kHeight);
    Counts counts;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            bool seen = false;
            for (int i = 0; i < 64; ++i) {
                const glm::vec2 at(static_cast<float>(i % 8) / 7.0f,
                                   static_cast<float>(i / 8) / 7.0f);
                const glm::vec3 d = rays.direction(static_cast<float>(x) + at.x * 0.999999f,
                                                   static_cast<float>(y) + at.y * 0.999999f);
                seen = seen || caster.cast(rays.eye, glm::normalize(d), -1).surface >= 0;
            }
            const bool drawn = mask[static_cast<std::size_t>(y * kWidth + x)] != 0;
            counts.seen += seen;
            counts.drawn += drawn;
            counts.missed += seen && !drawn;
        }
    }
    return counts;
}

TEST(Silhouette, HoldsAllThatRaysMeetAndLittleMore) {
    for (const std::string_view name : shapeNames()) {
        const Scene scene = sceneOfShape(name, metal());
        for (const glm::vec3 eye : {glm::vec3(0.3f, 0.8f, 5.0f), glm::vec3(-6.0f, 2.0f, 1.0f)}) {
            const Counts counts = count(scene, eyeAt(eye));
            EXPECT_EQ(counts.missed, 0) << name;
            EXPECT_GT(counts.seen, 0) << name;
            // A pixel's width all around.
            EXPECT_LT(counts.drawn, counts.seen + 200) << name;
        }
    }
}

TEST(Silhouette, TakesInWhatReachesBehindTheEye) {
    Scene scene;
    scene.parts.push_back({"floor", "", metal(), boxMesh({-50, -2, -50}, {50, -1, 50})});
    const Counts floor = count(scene, eyeAt({0.0f, 0.5f, 4.0f}));
    EXPECT_EQ(floor.missed, 0);
    EXPECT_GT(floor.seen, kWidth * kHeight / 4);
    EXPECT_LE(floor.drawn, floor.seen + kWidth);
    scene.parts.push_back({"room", "", metal(), boxMesh({-9, -9, -9}, {9, 9, 9})});
    EXPECT_EQ(count(scene, eyeAt({0.0f, 0.5f, 4.0f})).drawn, kWidth * kHeight);
}

TEST(Silhouette, DrawsLargeTrianglesNoWiderThanTheyAre) {
    Scene scene;
    Mesh mesh;
    mesh.positions = {{-2, -1.5f, 0}, {2, -1.5f, 0}, {-2, 1.5f, 0}};
    mesh.triangles = {{0, 1, 2}};
    scene.parts.push_back({"half", "", metal(), mesh});
    const Counts counts = count(scene, eyeAt({0.0f, 0.0f, 5.0f}));
    EXPECT_EQ(counts.missed, 0);
    EXPECT_LE(counts.drawn, counts.seen + 40);
}

TEST(Silhouette, IsEmptyWhereNothingIsAhead) {
    const Scene scene = sceneOfShape("torus-knot", metal());
    Camera camera = eyeAt({0.0f, 0.0f, 5.0f});
    camera.target = {0.0f, 0.0f, 10.0f};
    EXPECT_EQ(count(scene, camera).drawn, 0);
    Scene broken;
    Mesh mesh;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    mesh.positions = {{nan, 0, 0}, {1, nan, 0}, {0, 1, std::numeric_limits<float>::infinity()}};
    mesh.triangles = {{0, 1, 2}};
    broken.parts.push_back({"broken", "", metal(), mesh});
    EXPECT_EQ(count(broken, eyeAt({0.0f, 0.0f, 5.0f})).missed, 0);
}

/// Texels as different as those of a photograph.
Image grain() {
    Image panorama(256, 128);
    std::mt19937 random(5);
    for (glm::vec3& pixel : panorama.pixels())
        pixel = glm::vec3(std::uniform_real_distribution<float>(0.2f, 0.6f)(random));
    return panorama;
}

/// What pixels see of it, by 32 x 32 points in each.
Image seenBehind(const Image& panorama, const Camera& camera) {
    const EnvironmentMap map(panorama, 0.0f, 1.0f);
    const RayGenerator rays(camera, kWidth, kHeight);
    Image seen(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            for (int i = 0; i < 32 * 32; ++i) {
                const glm::vec2 at = glm::vec2(x, y) + (glm::vec2(i % 32, i / 32) + 0.5f) / 32.0f;
                seen.at(x, y) +=
                    map.radiance(glm::normalize(rays.direction(at.x, at.y)), 0.0f) / 1024.0f;
            }
        }
    }
    return seen;
}

TEST(Sky, IsTheMeanOverEachPixelWithoutNoise) {
    const Camera camera = eyeAt({0, 0, 4});
    const Image panorama = grain();
    const Image truth = seenBehind(panorama, camera);
    RenderOptions options;
    options.width = kWidth;
    options.height = kHeight;
    double before = 0.3;  // codes
    for (const int samples : {64, 256, 1024}) {
        options.samples = samples;
        options.seed = 0;
        const Rendering one = render(Scene{}, panorama, camera, options);
        options.seed = 1;
        const Rendering other = render(Scene{}, panorama, camera, options);
        EXPECT_EQ(rmse8(one.radiance, other.radiance), 0.0) << samples;
        EXPECT_EQ(one.rays, 0u) << samples;
        const double error = rmse8(one.radiance, truth);
        EXPECT_LT(error, before) << samples;
        before = 0.6 * error;
    }
}

}  // namespace
}  // namespace tukor::trace
