// The two renderers against each other: the same picture, within two codes of 255, of every solid
// shape and of imported models.
#include <cctype>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <gtest/gtest.h>

#include "tukor/base/test_folder.h"
#include "tukor/environment/environment.h"
#include "tukor/geometry/shapes.h"
#include "tukor/gl/context.h"
#include "tukor/gl/render.h"
#include "tukor/gl/renderer.h"
#include "tukor/image/compare.h"
#include "tukor/materials/materials.h"
#include "tukor/scene/assign_materials.h"
#include "tukor/scene/model_file.h"
#include "tukor/trace/render.h"

namespace tukor {
namespace {

/// A shape as another program would write it, bent along the way so that it is no built-in one.
void writeObject(std::ofstream& file, const std::string& shape, glm::vec3 scale, float bend,
                 int& firstVertex) {
    const Mesh mesh = makeShape(shape).value().front().mesh;
    fmt::print(file, "o {}\n", shape);
    for (const glm::vec3& p : mesh.positions) {
        const glm::vec3 q = scale * (p + glm::vec3(0.0f, bend * std::sin(3.0f * p.x), 0.0f));
        fmt::print(file, "v {} {} {}\n", q.x, q.y, q.z);
    }
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::ivec3 corner = firstVertex + glm::ivec3(t);
        fmt::print(file, "f {} {} {}\n", corner.x, corner.y, corner.z);
    }
    firstVertex += static_cast<int>(mesh.positions.size());
}

void writeModel(const std::string& name, const std::string& path) {
    std::ofstream file(path);
    int firstVertex = 1;
    if (name == "pebble") {
        writeObject(file, "sphere", {1.0f, 0.6f, 0.8f}, 0.3f, firstVertex);
    } else {  // a stone in a knotted band
        writeObject(file, "torus-knot", glm::vec3(1.0f), 0.0f, firstVertex);
        writeObject(file, "brilliant", glm::vec3(0.5f), 0.0f, firstVertex);
    }
}

struct Subject {
    std::string model;
    std::string material;
    double fullDepth;  // the share of object pixels that must agree
    bool onlyStable;   // of those that a shift of 1e-4 pixels changes by less than a code
    float dispersion = 0.0f;
};

Scene sceneOf(const Subject& subject) {
    const bool written = subject.model == "pebble" || subject.model == "ring";
    const TestFolder folder;
    const std::string file = folder.path(subject.model + ".obj");
    if (written) writeModel(subject.model, file);
    ModelOptions options;
    options.material = subject.material;
    Scene scene = loadModel(written ? file : subject.model, options);
    if (subject.dispersion > 0.0f) setDispersion(scene, subject.dispersion);
    if (subject.model == "ring") scene.parts.at(1).material = parseMaterial("diamond");
    return scene;
}

RenderOptions quick(int maxDepth, int samples) {
    RenderOptions options;
    options.width = 96;
    options.height = 54;
    options.samples = samples;
    options.maxDepth = maxDepth;
    options.background = Background::none;
    options.splitGain = 0.0f;  // gl follows every branch; so does trace here
    options.splitGrazing = false;
    options.weightCutoff = 1e-3f;
    return options;
}

/// `camera`, turned so that every ray moves by that many pixels.
Camera nudged(Camera camera, float pixels, int height) {
    const glm::vec3 forward = camera.target - camera.eye;
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const float angle =
        pixels * 2.0f * std::tan(0.5f * camera.verticalFov) / static_cast<float>(height);
    camera.target += right * (angle * glm::length(forward));
    return camera;
}

/// The pixels with the object in them that `keep` allows, as a picture of one row.
template <class Keep>
Image picked(const Image& image, const Image& coverage, Keep&& keep) {
    std::vector<glm::vec3> pixels;
    for (std::size_t i = 0; i < image.pixels().size(); ++i)
        if (coverage.alpha[i] > 0.0f && keep(i)) pixels.push_back(image.pixels()[i]);
    Image row(static_cast<int>(pixels.size()), 1);
    std::copy(pixels.begin(), pixels.end(), row.pixels().begin());
    return row;
}

class RendererPair : public testing::TestWithParam<Subject> {};

TEST_P(RendererPair, DrawTheSamePicture) {
    const Subject& subject = GetParam();
    const Scene scene = sceneOf(subject);
    const Environment light = loadEnvironment("studio");
    const Camera camera = framingCamera(scene, 16.0f / 9.0f);
    // With one sample, in the middle of the pixel, gl begins with what the rasteriser found.
    for (const auto& [depth, samples] : {std::pair(8, 1), std::pair(8, 2), std::pair(64, 2)}) {
        const RenderOptions options = quick(depth, samples);
        const Image a = gl::render(scene, light, camera, options).radiance;
        const Image b = trace::render(scene, light, camera, options).radiance;
        std::vector<bool> stable(a.pixels().size(), true);
        if (depth > 8 && subject.onlyStable) {
            const Image moved =
                trace::render(scene, light, nudged(camera, 1e-4f, options.height), options)
                    .radiance;
            for (std::size_t i = 0; i < stable.size(); ++i) {
                Image one(1, 1), other(1, 1);
                one.at(0, 0) = b.pixels()[i];
                other.at(0, 0) = moved.pixels()[i];
                stable[i] = compareImages(one, other).maximum8 < 1;
            }
        }
        const auto keep = [&](std::size_t i) { return stable[i]; };
        const Image rowA = picked(a, b, keep);
        const Image rowB = picked(b, b, keep);
        ASSERT_GT(rowA.width(), 250) << "too few pixels to say anything";
        const Comparison comparison = compareImages(rowA, rowB);
        EXPECT_GE(comparison.withinTwo8, depth == 8 ? 0.99 : subject.fullDepth)
            << "depth " << depth << ", " << rowA.width() << " pixels\n"
            << report(comparison);
        RecordProperty(fmt::format("depth{}samples{}", depth, samples),
                       std::to_string(comparison.withinTwo8));
        fmt::print("{} {} depth {}, {} samples: {:.3f} % of {} pixels within 2 codes\n",
                   subject.model, subject.material, depth, samples, 100.0 * comparison.withinTwo8,
                   rowA.width());
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, RendererPair,
                         testing::Values(Subject{"sphere", "glass", 0.999, false},
                                         Subject{"brilliant", "diamond", 0.999, false},
                                         Subject{"brilliant", "diamond", 0.995, true, 1.0f},
                                         Subject{"torus-knot", "gold", 0.995, true},
                                         Subject{"torus-knot", "glass", 0.995, true},
                                         Subject{"tumbler", "glass", 0.995, true},
                                         Subject{"teapot", "glass", 0.995, true},
                                         Subject{"pebble", "water", 0.995, true},
                                         Subject{"ring", "gold", 0.995, true}),
                         [](const testing::TestParamInfo<Subject>& tested) {
                             std::string name = tested.param.model + "_" + tested.param.material +
                                                (tested.param.dispersion > 0.0f ? "_fire" : "");
                             for (char& c : name)
                                 if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                             return name;
                         });

TEST(Renderers, BlurWhatLiesBehindAlike) {
    const Scene scene = sceneOf({"sphere", "gold", 1.0, false});
    const Environment light = loadEnvironment("studio");
    const Camera camera = framingCamera(scene, 16.0f / 9.0f);
    RenderOptions options = quick(8, 1);
    const Image ball = trace::render(scene, light, camera, options).radiance;
    options.background = Background::quad;
    for (const float roughness : {0.05f, 0.3f, 1.0f}) {
        options.backgroundBlur = roughness;
        const Rendering drawn = gl::render(scene, light, camera, options);
        EXPECT_GE(drawn.rays, 96u * 54u);
        const Image& a = drawn.radiance;
        const Image b = trace::render(scene, light, camera, options).radiance;
        int seen = 0;
        for (std::size_t i = 0; i < ball.alpha.size(); ++i) {
            if (ball.alpha[i] > 0.0f) continue;
            ++seen;
            EXPECT_LT(glm::distance(a.pixels()[i], b.pixels()[i]),
                      2e-3f * glm::length(b.pixels()[i]))
                << "roughness " << roughness << ", pixel " << i;
        }
        ASSERT_GT(seen, 1000);
    }
}

/// Means over blocks of that many pixels, as a picture of one row.
Image blocks(const Image& image, int size) {
    const int across = image.width() / size, down = image.height() / size;
    Image means(across * down, 1);
    for (int row = 0; row < down * size; ++row)
        for (int column = 0; column < across * size; ++column)
            means.at(row / size * across + column / size, 0) +=
                image.at(column, row) / static_cast<float>(size * size);
    return means;
}

/// White, as much as the alpha of another.
Image alphaOf(const Image& image) {
    Image white(image.width(), image.height());
    for (std::size_t i = 0; i < image.alpha.size(); ++i)
        white.pixels()[i] = glm::vec3(image.alpha[i]);
    return white;
}

// What is by chance is compared by its means: shadows and caustics of glass, of a metal's
// reflections, of a lamp.
TEST(Renderers, ThrowTheSameLightOnGround) {
    const Environment light = loadEnvironment("studio");
    for (const auto& [model, material] : {std::pair("sphere", "glass"), {"torus-knot", "gold"}}) {
        Scene scene = sceneOf({model, material, 1.0, false});
        if (scene.parts[0].name == "torus-knot") {
            Light lamp;
            lamp.direction = glm::normalize(glm::vec3(-1.0f, -2.0f, -0.5f));
            lamp.intensity = glm::vec3(2.0f);
            scene.lights.push_back(lamp);
        }
        Camera camera = framingCamera(scene, 16.0f / 9.0f);
        camera.eye += glm::vec3(0.0f, 2.0f, 0.0f);
        RenderOptions options = quick(8, 64);
        options.background = Background::quad;
        options.ground = boundsOf(scene).least.y;
        const Image a = blocks(gl::render(scene, light, camera, options).radiance, 9);
        options.samples = 256;
        const Image b = blocks(trace::render(scene, light, camera, options).radiance, 9);
        const Comparison comparison = compareImages(a, b);
        fmt::print("{} on ground: RMSE {:.2f} codes over {} blocks\n", model, comparison.rmse8,
                   a.width());
        EXPECT_LT(comparison.rmse8, 1.0) << model << '\n' << report(comparison);
        options.background = Background::none;
        const Image shadows =
            blocks(alphaOf(trace::render(scene, light, camera, options).radiance), 9);
        options.samples = 64;
        const Image drawn = blocks(alphaOf(gl::render(scene, light, camera, options).radiance), 9);
        EXPECT_LT(compareImages(shadows, drawn).rmse8, 2.0)
            << report(compareImages(shadows, drawn));
        options.background = Background::quad;
        options.ground.reset();
        const Image bare = blocks(trace::render(scene, light, camera, options).radiance, 9);
        EXPECT_GT(compareImages(b, bare).rmse8, 5.0) << "no shadow to compare";
    }
}

// Views that move show the light on ground that was gathered while they were at rest.
TEST(Renderers, KeepTheLightOnGroundWhileTheViewMoves) {
    const gl::Context context;
    for (const Background background : {Background::quad, Background::none}) {
        gl::Renderer renderer;
        const Scene scene = sceneOf({"sphere", "gold", 1.0, false});
        renderer.setScene(scene);
        renderer.setEnvironment(loadEnvironment("studio"));
        Camera camera = framingCamera(scene, 16.0f / 9.0f);
        camera.eye += glm::vec3(0.0f, 2.0f, 0.0f);
        gl::FrameOptions options{quick(8, 64), {}, {}};
        options.picture.background = background;
        options.picture.ground = -1.0f;
        const auto drawn = [&](int samples) {
            options.picture.samples = samples;
            renderer.resetAccumulation();
            for (int i = 0; i < samples; ++i) renderer.drawFrame(camera, options);
            const Image image = renderer.read().radiance;
            return blocks(background == Background::none ? alphaOf(image) : image, 9);
        };
        const Image bare = drawn(1);
        for (int i = 0; i < 32; ++i) renderer.gatherGroundLight(camera, options);
        camera.eye += glm::vec3(0.5f, -0.2f, 0.0f);
        const Image moving = drawn(1), still = drawn(64);
        // Some of it is the outline of the ball, which a single sample does not smooth.
        const double apart = compareImages(still, moving).rmse8;
        const double without = compareImages(still, bare).rmse8;
        fmt::print("ground while the view moves: RMSE {:.2f} codes, {:.2f} without\n", apart,
                   without);
        EXPECT_LT(apart, without / 4.0);
        renderer.setLights({});
        EXPECT_GT(compareImages(still, drawn(1)).rmse8, 5.0) << "light of another scene";
    }
}

}  // namespace
}  // namespace tukor
