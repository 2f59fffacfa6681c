#include "tukor/trace/render.h"

#include <cmath>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/base/parallel.h"
#include "tukor/geometry/shapes.h"
#include "tukor/geometry/tumbler.h"
#include "tukor/trace/test_scenes.h"

namespace tukor::trace {
namespace {

RenderOptions small(int samples) {
    RenderOptions options;
    options.width = 48;
    options.height = 32;
    options.samples = samples;
    return options;
}

/// The largest distance of any channel of any pixel from `value`.
float mostFrom(const Image& image, float value) {
    float most = 0.0f;
    for (const glm::vec3& pixel : image.pixels()) {
        for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(pixel[c] - value));
    }
    return most;
}

TEST(TraceRender, WhiteFurnaceIsOneOnEveryShapeAtEveryBudget) {
    for (const std::string_view name : shapeNames()) {
        const Scene scene = sceneOfShape(name, clear(1.5f, 1));
        for (const int budget : {1, 2, 8, 128}) {
            RenderOptions options = small(4);
            options.rayBudget = budget;
            options.splitGain = budget == 8 ? 0.0f : 0.0625f;
            const Rendering r = render(scene, constantCube(1.0f), eyeAt({0.5f, 1, 3.5f}), options);
            EXPECT_LT(mostFrom(r.radiance, 1.0f), 1e-5f) << name << " at " << budget << " rays";
            EXPECT_EQ(r.leaks, 0u) << name;
        }
    }
}

TEST(TraceRender, LevelsBelowExactLoseNothingEither) {
    const Scene scene = sceneOfShape("torus-knot", clear(1.5f, 1));
    for (const Fidelity fidelity : {Fidelity::single, Fidelity::two}) {
        RenderOptions options = small(4);
        options.fidelity = fidelity;
        const Rendering r = render(scene, constantCube(1.0f), eyeAt({0, 1, 3.5f}), options);
        EXPECT_LT(mostFrom(r.radiance, 1.0f), 1e-5f);
    }
}

TEST(TraceRender, BlursWhatLiesBehindTheSceneAlone) {
    CubeMap environment(32);  // a gradient, of which the widest blur leaves two thirds
    for (const CubeFace face : kCubeFaces)
        for (int i = 0; i < 32 * 32; ++i)
            environment.texels(face)[static_cast<std::size_t>(i)] =
                0.5f + 0.3f * glm::normalize(directionFromTexel({face, i % 32, i / 32}, 32));
    const Scene scene = sceneOfShape("sphere", clear(1.5f, 1));
    RenderOptions options = small(4);
    const Image sharp = render(scene, environment, eyeAt({0, 0, 6}), options).radiance;
    options.backgroundBlur = 1.0f;
    const Image blurred = render(scene, environment, eyeAt({0, 0, 6}), options).radiance;
    EXPECT_EQ(blurred.at(24, 16), sharp.at(24, 16));
    for (const auto& [column, row] : {std::pair(0, 0), {47, 0}, {3, 31}, {40, 20}})
        EXPECT_LT(glm::length(blurred.at(column, row) -
                              glm::mix(glm::vec3(0.5f), sharp.at(column, row), 2.0f / 3.0f)),
                  2e-3f)
            << column << ", " << row;
}

TEST(TraceRender, ThreadsDoNotChangeThePicture) {
    const Scene scene = sceneOfShape("brilliant", clear(2.42f, 1));
    RenderOptions options = small(16);
    const auto picture = [&](int threads) {
        setThreadCount(threads);
        return render(scene, gradientCube(), eyeAt({0.5f, 1, 3}), options);
    };
    for (const std::optional<float> error : {std::optional<float>(), std::optional(1.0f)}) {
        options.error = error;
        const Rendering one = picture(1), two = picture(2);
        setThreadCount(0);
        EXPECT_EQ(one.rays, two.rays);
        EXPECT_TRUE(std::equal(one.radiance.pixels().begin(), one.radiance.pixels().end(),
                               two.radiance.pixels().begin()));
    }
}

TEST(TraceRender, SlabAbsorbsExponentially) {
    // Of index 1, so that nothing else happens to the light.
    Scene scene = sceneOfShape("brilliant", clear(1.0f, 1));
    scene.parts[0].mesh = boxMesh({-9, -9, -0.25f}, {9, 9, 0.25f});
    scene.parts[0].material.sigmaA = {0.3f, 1.0f, 4.0f};
    RenderOptions options = small(1);
    options.width = options.height = 1;
    Camera camera = eyeAt({0, 0, 4});
    camera.verticalFov = 1e-3f;
    const glm::vec3 L = render(scene, constantCube(2.0f), camera, options).radiance.at(0, 0);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(L[c], 2.0f * std::exp(-0.5f * scene.parts[0].material.sigmaA[c]), 2e-6f);
    }
}

TEST(TraceRender, EyesInsideOfGlassSeeOut) {
    Scene scene = sceneOfShape("sphere", clear(1.5f, 1));
    RenderOptions options = small(4);
    const Rendering r = render(scene, constantCube(1.0f), eyeAt({0.1f, 0.2f, 0.3f}), options);
    EXPECT_EQ(r.inconsistencies, 0u);
    EXPECT_EQ(r.leaks, 0u);
    EXPECT_LT(mostFrom(r.radiance, 1.0f), 1e-5f);
}

TEST(TraceRender, RaysThatTouchAnEdgeKeepTrackOfTheirMedia) {
    // Of water within something of higher priority that does not bend them.
    Scene scene = sceneOfShape("cube", clear(1.333f, 1));
    scene.parts.push_back({"around", "", clear(1.0f, 2), scene.parts[0].mesh});
    for (glm::vec3& p : scene.parts[1].mesh.positions) p *= 2.0f;
    RenderOptions options = small(1);
    options.width = options.height = 1;
    options.retakeFaulty = false;
    const float edge = boundsOf(scene.parts[0].mesh).most.x;
    std::uint64_t faults = 0;
    for (int i = 0; i < 1000; ++i) {
        Camera camera = eyeAt({0.003f * edge * static_cast<float>(i % 100), 4.0f * edge,
                               edge * (0.0013f * static_cast<float>(i) - 0.65f)});
        camera.target = {edge, edge, camera.eye.z};
        camera.verticalFov = 1e-3f;
        const Rendering r = render(scene, constantCube(1.0f), camera, options);
        faults += r.inconsistencies + r.leaks;
    }
    EXPECT_EQ(faults, 0u);
}

TEST(TraceRender, ErrorCountsBeyondWhite) {
    // Mirror images of suns: what varies among the samples of their pixels is white to a display.
    CubeMap sun(32);
    for (const CubeFace face : kCubeFaces) std::ranges::fill(sun.texels(face), glm::vec3(0.5f));
    for (int row = 1; row < 32; row += 3)
        for (int column = 1; column < 32; column += 3)
            sun.texels(CubeFace::posZ)[static_cast<std::size_t>(row * 32 + column)] *= 1e4f;
    const Scene scene = sceneOfShape("sphere", metal());
    const auto picture = [&](int samples, std::optional<float> error) {
        RenderOptions options = small(samples);
        options.error = error;
        return render(scene, sun, eyeAt({0, 0, 4}), options).radiance;
    };
    const Image limit = picture(1024, std::nullopt), found = picture(1024, 1.0f);
    double off = 0.0, all = 0.0;
    for (std::size_t i = 0; i < limit.pixels().size(); ++i) {
        const float a = found.pixels()[i].x, b = limit.pixels()[i].x;
        off += (a - b) * (a - b);
        all += b * b;
    }
    EXPECT_LT(std::sqrt(off / all), 0.05);  // 0.2 by what displays show alone
}

TEST(TraceRender, OpenModelsAreCounted) {
    Scene scene = sceneOfShape("sphere", clear(1.5f, 1));
    scene.parts[0].mesh.triangles.resize(scene.parts[0].mesh.triangles.size() / 2);
    const Rendering r = render(scene, constantCube(1.0f), eyeAt({0, 2, 3}), small(4));
    EXPECT_GT(r.leaks + r.inconsistencies, 100u);
}

TEST(TraceRender, FaultySamplesAreTakenAgainALittleAside) {
    // A cube with a crack in its front, far finer than a pixel, where the only sample is.
    Scene scene = sceneOfShape("cube", clear(1.5f, 1));
    Mesh& mesh = scene.parts[0].mesh;
    const float half = boundsOf(mesh).most.x, crack = 2e-5f * half;
    const auto at = [&](float x, float y) {
        mesh.positions.push_back({x, y, half});
        mesh.normals.push_back({0, 0, 1});
        return static_cast<unsigned>(mesh.positions.size()) - 1;
    };
    std::erase_if(mesh.triangles, [&](glm::uvec3 t) {
        return mesh.positions[t.x].z + mesh.positions[t.y].z + mesh.positions[t.z].z > 2.9f * half;
    });
    for (const float side : {-1.0f, 1.0f}) {
        const unsigned a = at(std::min(side * half, side * crack), -half),
                       b = at(std::max(side * half, side * crack), -half),
                       c = at(std::max(side * half, side * crack), half),
                       d = at(std::min(side * half, side * crack), half);
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    }
    mesh.uvs = {};
    RenderOptions options = small(1);
    options.width = options.height = 1;
    Camera camera = eyeAt({0, 0.1f, 4});  // past the diagonals of its faces
    camera.target = {0, 0.1f, 0};
    options.retakeFaulty = false;
    EXPECT_GT(render(scene, constantCube(1.0f), camera, options).inconsistencies, 0u);
    const Image faulty = render(scene, gradientCube(), camera, options).radiance;
    options.retakeFaulty = true;
    const Rendering mended = render(scene, constantCube(1.0f), camera, options);
    EXPECT_EQ(mended.leaks + mended.inconsistencies, 0u);
    EXPECT_LT(mostFrom(mended.radiance, 1.0f), 1e-5f);
    EXPECT_NE(render(scene, gradientCube(), camera, options).radiance.at(0, 0), faulty.at(0, 0));
}

TEST(TraceRender, NoBackgroundMeansCoverageInAlpha) {
    RenderOptions options = small(16);
    options.background = Background::none;
    const Scene scene = sceneOfShape("sphere", metal());
    const Rendering r = render(scene, constantCube(1.0f), eyeAt({0, 0, 4}), options);
    ASSERT_EQ(r.radiance.alpha.size(), r.radiance.pixels().size());
    EXPECT_EQ(r.radiance.alpha.front(), 0.0f);
    EXPECT_EQ(r.radiance.at(0, 0), glm::vec3(0.0f));
    EXPECT_EQ(r.radiance.alpha[16 * 48 + 24], 1.0f);
    EXPECT_TRUE(
        render(scene, constantCube(1.0f), eyeAt({0, 0, 4}), small(1)).radiance.alpha.empty());
}

TEST(TraceRender, RotationIsCounterClockwiseSeenFromAbove) {
    // What was at -Z, ahead, goes to -X, to the left; a quarter turn brings +X ahead.
    CubeMap cube(8);
    for (glm::vec3& texel : cube.texels(CubeFace::posX)) texel = glm::vec3(1.0f, 0.0f, 0.0f);
    for (glm::vec3& texel : cube.texels(CubeFace::negZ)) texel = glm::vec3(0.0f, 1.0f, 0.0f);
    RenderOptions options = small(4);
    const Camera ahead = eyeAt({0, 0, 4});
    EXPECT_GT(render(Scene{}, cube, ahead, options).radiance.at(24, 16).y, 0.99f);
    options.environmentRotation = 1.5707963f;
    options.environmentIntensity = 3.0f;
    const Image turned = render(Scene{}, cube, ahead, options).radiance;
    EXPECT_NEAR(turned.at(24, 16).x, 3.0f, 1e-4f);
}

TEST(TraceRender, StopsWhenToldAndKeepsWhatItHas) {
    RenderOptions options = small(1024);
    int calls = 0;
    const Rendering r = render(sceneOfShape("sphere", metal()), constantCube(1.0f),
                               eyeAt({0, 0, 4}), options, [&](float fraction, std::uint64_t) {
                                   EXPECT_GE(fraction, 0.0f);
                                   EXPECT_LE(fraction, 1.0f);
                                   return ++calls < 1;
                               });
    EXPECT_EQ(calls, 1);
    EXPECT_LT(r.samplesPerPixel, 1024.0);
    options.samples.reset();
    options.timeSeconds = 0.05f;
    EXPECT_GT(render(sceneOfShape("sphere", metal()), gradientCube(), eyeAt({0, 0, 4}), options)
                  .samplesPerPixel,
              0.9);
}

TEST(TraceRender, LayersKnowTheCentreOfThePixel) {
    RenderOptions options = small(1);
    options.width = options.height = 33;
    options.layers = {AovLayer::depth, AovLayer::normal, AovLayer::material, AovLayer::bounces};
    const Rendering r =
        render(sceneOfShape("sphere", metal()), constantCube(1.0f), eyeAt({0, 0, 4}), options);
    ASSERT_EQ(r.layers.size(), 4u);
    EXPECT_EQ(r.layers[0].name, "depth");
    EXPECT_NEAR(r.layers[0].image.at(16, 16).x, 3.0f, 1e-3f);
    EXPECT_NEAR(r.layers[1].image.at(16, 16).z, 1.0f, 1e-3f);
    EXPECT_EQ(r.layers[2].image.at(16, 16).x, 1.0f);
    EXPECT_EQ(r.layers[3].image.at(16, 16).x, 1.0f);
    EXPECT_EQ(r.layers[0].image.at(0, 0), glm::vec3(0.0f));
}

TEST(TraceRender, SaysWhatIsWrongWithTheSize) {
    RenderOptions options;
    options.width = 0;
    try {
        (void)render(Scene{}, constantCube(1.0f), Camera{}, options);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "0 x 720 pixels; a picture has at least 1 and at most 2^30");
    }
}

TEST(TraceRender, ErrorMeansWhatItSays) {
    // Against 512 samples: the expected error is within a factor of 1.5 of the true one.
    for (const char* shape : {"sphere", "torus-knot"}) {
        const Scene scene = sceneOfShape(shape, clear(1.5f, 1));
        const Camera camera = eyeAt({0, 1.5f, 3});
        RenderOptions options = small(512);
        options.width = 36;
        options.height = 24;
        const Image truth = render(scene, gradientCube(), camera, options).radiance;
        options.seed = 7;
        options.error = 6.0f;
        const Rendering r = render(scene, gradientCube(), camera, options);
        const double real = rmse8(r.radiance, truth);
        ASSERT_TRUE(r.error.has_value());
        EXPECT_LT(*r.error, 6.0);
        EXPECT_LT(real, 1.5 * *r.error) << shape << " at " << r.samplesPerPixel << " samples";
        EXPECT_GT(real, *r.error / 1.5) << shape << " at " << r.samplesPerPixel << " samples";
    }
}

}  // namespace
}  // namespace tukor::trace
