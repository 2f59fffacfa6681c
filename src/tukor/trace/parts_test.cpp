// The pieces of the CPU renderer, one by one.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tukor/environment/equirect.h"
#include "tukor/geometry/tumbler.h"
#include "tukor/trace/environment_map.h"
#include "tukor/trace/error_estimate.h"
#include "tukor/trace/frame.h"
#include "tukor/trace/path_pool.h"
#include "tukor/trace/test_scenes.h"
#include "tukor/transport/sampler.h"

namespace tukor::trace {
namespace {

std::vector<glm::vec3> directions(int count) {
    std::mt19937 random(3);
    std::normal_distribution<float> normal;
    std::vector<glm::vec3> all;
    for (int i = 0; i < count; ++i) {
        all.push_back(glm::normalize(glm::vec3(normal(random), normal(random), normal(random))));
    }
    return all;
}

TEST(EnvironmentMap, LooksUpAsTheCubeMapDoes) {
    const CubeMap cube = gradientCube();
    const EnvironmentMap map(cube, 0.0f, 2.0f);
    for (const glm::vec3& d : directions(20000)) {
        EXPECT_LT(glm::distance(map.radiance(d, 0.0f), 2.0f * cube.radiance(d)), 2e-5f);
    }
}

TEST(EnvironmentMap, LooksUpAsThePanoramaDoes) {
    Image panorama(64, 32);
    std::mt19937 random(5);
    for (glm::vec3& pixel : panorama.pixels()) {
        pixel = glm::vec3(std::uniform_real_distribution<float>(0, 1)(random));
    }
    const EnvironmentMap map(panorama, 0.0f, 1.0f);
    for (const glm::vec3& d : directions(20000)) {
        EXPECT_LT(glm::distance(map.radiance(d, 0.0f), equirectRadiance(panorama, d)), 1e-4f);
    }
}

TEST(EnvironmentMap, WideFootprintsSeeMeans) {
    const EnvironmentMap cube(gradientCube(), 0.0f, 1.0f);
    Image panorama(256, 128);
    for (int row = 0; row < 128; ++row) {
        for (int column = 0; column < 256; ++column) {
            panorama.at(column, row) = glm::vec3(static_cast<float>((column + row) % 2));
        }
    }
    const EnvironmentMap checker(panorama, 0.0f, 1.0f);
    for (const glm::vec3& d : directions(100)) {
        EXPECT_NEAR(checker.radiance(d, 0.05f).x, 0.5f, 1e-3f);
        const glm::vec3 wide = cube.radiance(d, 10.0f), widest = cube.radiance(d, 1e9f);
        EXPECT_EQ(wide, widest);
        EXPECT_EQ(checker.radiance(d, glm::vec3(0.0f), glm::vec3(0.0f), 16),
                  checker.radiance(d, 0.0f));
    }
}

TEST(EnvironmentMap, LongFootprintsSeeTheMeanAlongThem) {
    // A bright half: across the edge half of the light, along it all or nothing.
    Image panorama(256, 128);
    for (int row = 0; row < 64; ++row) {
        for (int column = 0; column < 256; ++column) panorama.at(column, row) = glm::vec3(1.0f);
    }
    const EnvironmentMap map(panorama, 0.0f, 1.0f);
    const glm::vec3 up(0, 0.2f, 0), right(0.2f, 0, 0), none(0.0f);
    EXPECT_NEAR(map.radiance({0, 0, -1}, up, none, 16).x, 0.5f, 0.01f);
    EXPECT_NEAR(map.radiance(glm::normalize(glm::vec3(0, 0.05f, -1)), right, none, 16).x, 1.0f,
                0.01f);
    EXPECT_NEAR(map.radiance(glm::normalize(glm::vec3(0, 0.05f, -1)), up, none, 16).x, 0.75f,
                0.03f);
    const float nan = std::nanf("");
    EXPECT_TRUE(std::isfinite(map.radiance({0, 0, -1}, glm::vec3(nan), right, 16).x));
}

TEST(Sampler, PrefixesAreStratified) {
    // 16 samples: one in each cell of every grid of 16 elementary intervals.
    for (std::uint32_t seed : {1u, 77u, 123456789u}) {
        for (int log = 0; log <= 4; ++log) {
            int cells[16] = {};
            for (std::uint32_t i = 0; i < 16; ++i) {
                const glm::vec2 p = transport::pixelSample(seed, i);
                const int across = 1 << log, down = 16 >> log;
                ++cells[static_cast<int>(p.x * float(across)) * down +
                        static_cast<int>(p.y * float(down))];
            }
            for (const int cell : cells) EXPECT_EQ(cell, 1);
        }
    }
}

TEST(Sampler, WideSamplesAreCutOffAtTheEdgesOfTheirPixel) {
    for (const float width : {0.05f, 0.35f, 0.7f}) {
        for (std::uint32_t i = 0; i < 256; ++i) {
            const transport::PixelPart part = transport::pixelPart(7u, i, width);
            const glm::vec2 at = transport::pixelSample(7u, i);
            for (int axis = 0; axis < 2; ++axis) {
                const float least = part.middle[axis] - 0.5f * part.size[axis];
                const float most = part.middle[axis] + 0.5f * part.size[axis];
                EXPECT_NEAR(least, std::max(at[axis] - 0.5f * width, 0.0f), 1e-6f);
                EXPECT_NEAR(most, std::min(at[axis] + 0.5f * width, 1.0f), 1e-6f);
            }
        }
    }
}

TEST(RayCaster, DoesNotSeeTheTriangleThatItLeaves) {
    const Scene scene = sceneOfShape("torus-knot", metal());
    const SurfaceTable surfaces(scene);
    const RayCaster caster(surfaces);
    int same = 0, met = 0;
    for (const glm::vec3& d : directions(5000)) {
        const RayHit hit = caster.cast(4.0f * d, -d, -1);
        if (hit.surface < 0) continue;
        ++met;
        const transport::SurfaceHit surface = surfaces.at(hit, 4.0f * d, -d);
        const RayHit next = caster.cast(surface.position, d, surface.triangle);
        same += next.surface >= 0 && surfaces.number(next) == surface.triangle;
    }
    EXPECT_GT(met, 1000);
    EXPECT_EQ(same, 0);
}

TEST(RayCaster, DoesNotMeetANeighbourInTheSamePlaneAtOnce) {
    Mesh mesh;  // two triangles of a square at y = 0, one below
    mesh.positions = {{-1, 0, -1},  {1, 0, -1},  {1, 0, 1}, {-1, 0, 1},
                      {-9, -1, -9}, {9, -1, -9}, {0, -1, 9}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};
    mesh.normals.assign(7, {0, 1, 0});
    Scene scene;
    scene.parts = {{"square", "", metal(), mesh}};
    const SurfaceTable surfaces(scene);
    const RayCaster caster(surfaces);
    const RayHit leaves = caster.cast({0.5f, 1, -0.5f}, {0, -1, 0}, -1);
    const int skip = surfaces.number(leaves);
    // Rounding has put its beginning on the other one.
    const RayHit next = caster.cast({-0.5f, 0, 0.5f}, {0.6f, -0.8f, 0}, skip);
    ASSERT_EQ(next.surface, 0);
    EXPECT_EQ(next.triangle, 2) << next.distance;
}

TEST(MediaAround, KnowsWaterWithinGlass) {
    Scene scene;
    Tumbler tumbler = makeTumbler();
    scene.parts = {{"glass", "", clear(1.5f, 2), tumbler.glass},
                   {"water", "", clear(1.33f, 1), tumbler.water}};
    const SurfaceTable surfaces(scene);
    const RayCaster caster(surfaces);
    EXPECT_EQ(mediaAround({0, -0.2f, 0}, surfaces, caster), 1u) << "in the water";
    EXPECT_EQ(mediaAround({0, -0.999f, 0}, surfaces, caster), 2u) << "in the glass's bottom";
    EXPECT_EQ(mediaAround({0, 0.95f, 0}, surfaces, caster), 0u) << "above the water";
    EXPECT_EQ(mediaAround({0, 5, 0}, surfaces, caster), 0u);
}

Image traced(const SurfaceTable& surfaces) {
    const RayCaster caster(surfaces);
    const EnvironmentMap map(gradientCube(), 0.0f, 1.0f);
    RenderOptions options;
    options.rayBudget = 4096;
    options.splitGain = 0.0f;
    const Camera camera = eyeAt({0, 1.5f, 3.5f});
    const Frame frame{
        surfaces, caster, map, RayGenerator(camera, 48, 32), transportSettings(options), 0u, true,
        48,       32,     0u};
    PathPool pool(frame);
    std::vector<PixelSum> sums(48 * 32);
    std::vector<CameraSample> samples;
    for (int i = 0; i < 48 * 32; ++i) {
        samples.push_back({glm::vec2(i % 48, i / 48) + 0.5f, glm::vec2(1.0f), i, 1u});
    }
    pool.trace(samples, sums);
    EXPECT_EQ(pool.counts().leaks, 0u);
    EXPECT_EQ(pool.counts().inconsistencies, 0u);
    Image image(48, 32);
    for (std::size_t i = 0; i < sums.size(); ++i) image.pixels()[i] = sums[i].radiance;
    return image;
}

TEST(PathPool, OverlappingTumblerEqualsExplicitInterfaces) {
    Tumbler tumbler = makeTumbler();
    const std::vector<DielectricMedium> media = {{1.333f, glm::vec3(0.1f)},
                                                 {1.5f, glm::vec3(0.2f)}};
    const SurfaceTable overlapping(std::vector<Surface>{{&tumbler.glass, clear(1.5f, 2), 2u, 0u},
                                                        {&tumbler.water, clear(1.333f, 1), 1u, 0u}},
                                   media);
    const std::vector<MediumInterface> sheets = makeTumblerInterfaces();
    std::vector<Surface> surfaces;
    const auto bit = [](const std::string& name) {
        return name.empty() ? 0u : name == "glass" ? 2u : 1u;
    };
    for (const MediumInterface& sheet : sheets) {
        surfaces.push_back({&sheet.mesh, clear(1.5f, 1), bit(sheet.back), bit(sheet.front)});
    }
    const Image a = traced(overlapping), b = traced(SurfaceTable(surfaces, media));
    // Paths of many bounces are chaotic, and the two restart at other places: a few pixels differ.
    int different = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        different += glm::distance(srgbCode(a.pixels()[i]), srgbCode(b.pixels()[i])) > 2.0f;
    }
    EXPECT_LT(different, 48 * 32 / 100);
}

}  // namespace
}  // namespace tukor::trace
