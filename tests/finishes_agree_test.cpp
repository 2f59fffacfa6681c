// Surfaces with a finish beside exact glass and metal: what `gl` shows of them through glass and in
// mirrors against `trace`.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tukor/environment/environment.h"
#include "tukor/geometry/sphere.h"
#include "tukor/gl/render.h"
#include "tukor/scene/finish.h"
#include "tukor/scene/material_text.h"
#include "tukor/trace/render.h"

namespace tukor {
namespace {

std::shared_ptr<const Texels> stripes() {
    auto texels = std::make_shared<Texels>();
    texels->width = texels->height = 64;
    for (int row = 0; row < 64; ++row)
        for (int column = 0; column < 64; ++column) {
            const bool odd = column / 16 % 2 == 1;
            for (const int c : {odd ? 220 : 40, odd ? 120 : 60, odd ? 40 : 150})
                texels->bytes.push_back(static_cast<std::uint8_t>(c));
        }
    return texels;
}

/// A sheet that faces +Z.
Mesh sheet(float halfWidth, float z) {
    Mesh mesh;
    for (const float y : {-1.0f, 1.0f})
        for (const float x : {-1.0f, 1.0f}) {
            mesh.positions.emplace_back(halfWidth * x, halfWidth * y, z);
            mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
            mesh.uvs[0].emplace_back(0.5f + 0.5f * x, 0.5f - 0.5f * y);
        }
    mesh.triangles = {{0, 1, 3}, {0, 3, 2}};
    return mesh;
}

Mesh ball(float radius, glm::vec3 centre) {
    Mesh mesh = makeSphere(24);
    for (glm::vec3& p : mesh.positions) p = radius * p + centre;
    return mesh;
}

Part finished(Mesh mesh, const Finish& finish) {
    Part part{"part", "part", mirrorMaterial(glm::vec3(0.5f)), std::move(mesh)};
    part.material.finish = std::make_shared<Finish>(finish);
    return part;
}

Finish matt(glm::vec3 colour) {
    Finish finish;
    finish.baseColor = colour;
    finish.metallic = 0.0f;
    finish.roughness = 0.6f;
    return finish;
}

/// A glass ball before a striped sheet, beside a mirror ball that reflects a matt one.
Scene mixed(bool unlit) {
    Scene scene;
    Finish striped = matt(glm::vec3(1.0f));
    striped.maps[0].texels = stripes();
    Finish red = matt({0.7f, 0.1f, 0.08f});
    striped.unlit = red.unlit = unlit;
    scene.parts.push_back(finished(sheet(2.0f, -2.5f), striped));
    scene.parts.push_back(finished(ball(0.6f, {2.3f, 0.0f, 0.6f}), red));
    scene.parts.push_back({"glass", "glass", parseMaterial("glass"), ball(0.8f, {-0.9f, 0, 0})});
    scene.parts.push_back(
        {"mirror", "mirror", mirrorMaterial({0.9f, 0.9f, 0.9f}), ball(0.8f, {0.9f, 0, 0})});
    return scene;
}

Environment uniform() {
    Environment white{"white", CubeMap(4), {}};
    for (const CubeFace face : kCubeFaces)
        for (glm::vec3& texel : white.radiance.texels(face)) texel = glm::vec3(1.0f);
    return white;
}

Camera camera() {
    Camera camera;
    camera.eye = {0.0f, 0.0f, 6.0f};
    camera.target = glm::vec3(0.0f);
    camera.verticalFov = 0.5f;
    return camera;
}

RenderOptions options(int samples) {
    RenderOptions options;
    options.width = 128;
    options.height = 48;
    options.samples = samples;
    return options;
}

glm::vec3 meanOf(const Image& image, int left, int top, int right, int bottom) {
    glm::vec3 sum(0.0f);
    for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column) sum += image.at(column, row);
    return sum / static_cast<float>((right - left) * (bottom - top));
}

struct Region {
    const char* name;
    int left, top, right, bottom;
};
// Of 128 x 48 pixels: the picture seen directly, the middle of the glass ball, its rim, the side of
// the mirror that shows the matt ball.
constexpr Region kRegions[] = {{"sheet", 58, 4, 70, 44},
                               {"glass", 38, 18, 50, 30},
                               {"rim of glass", 30, 20, 34, 28},
                               {"mirror", 92, 20, 97, 28}};

void expectAlike(const Scene& scene, float tolerance, int samples) {
    const Environment light = loadEnvironment("studio");
    const Image a = gl::render(scene, light, camera(), options(16)).radiance;
    const Image b = trace::render(scene, light, camera(), options(samples)).radiance;
    for (const Region& r : kRegions) {
        const glm::vec3 x = meanOf(a, r.left, r.top, r.right, r.bottom);
        const glm::vec3 y = meanOf(b, r.left, r.top, r.right, r.bottom);
        fmt::print("{}: gl {:.3f} {:.3f} {:.3f}, trace {:.3f} {:.3f} {:.3f}\n", r.name, x.x, x.y,
                   x.z, y.x, y.y, y.z);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(x[c], y[c], tolerance * (0.05f + y[c])) << r.name;
    }
}

// Nothing of it depends on light: the same picture within the noise of trace, measured as 1 %.
TEST(Finishes, UnlitOnesLookAlikeThroughGlassAndInMirrors) {
    expectAlike(mixed(true), 0.02f, 96);
}

// gl knows neither shadows nor light between surfaces: measured, up to 15 % in the mirror.
TEST(Finishes, LitOnesLookMuchAlikeThroughGlassAndInMirrors) {
    expectAlike(mixed(false), 0.2f, 64);
}

TEST(Finishes, WhiteOnesBesideGlassAreInvisibleInUniformLight) {
    const Environment white = uniform();
    Scene scene = mixed(false);
    scene.parts[0].material.finish = std::make_shared<Finish>(matt(glm::vec3(1.0f)));
    scene.parts[1].material.finish = scene.parts[0].material.finish;
    scene.parts[2].material.sigmaA = glm::vec3(0.0f);
    scene.parts[3].material.tint = glm::vec3(1.0f);
    for (const Fidelity fidelity : {Fidelity::two, Fidelity::exact}) {
        RenderOptions quick = options(2);
        quick.fidelity = fidelity;
        const Image image = gl::render(scene, white, camera(), quick).radiance;
        for (const glm::vec3& pixel : image.pixels())
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(pixel[c], 1.0f, 0.01f);
    }
}

Scene ballOf(std::string_view material) {
    Scene scene;
    scene.parts.push_back({"ball", "", materialFromText(material), ball(1.2f, glm::vec3(0.0f))});
    return scene;
}

/// Of the picture's middle, which shows the ball alone.
glm::vec3 middleOf(const Rendering& picture) {
    return meanOf(picture.radiance, 52, 12, 76, 36);
}

// Without neighbours there are no shadows to miss. The split sum is within 3 % of what is traced
// (docs/features.md), the noise within 1 %.
TEST(Finishes, ByNameLookAlikeInBothRenderers) {
    const Environment light = loadEnvironment("studio");
    for (const char* material : {"gold+rough:0.1", "gold+rough:0.3", "iron+rough:0.6",
                                 "mirror:0.9,0.6,0.3+rough:0.4", "matt:0.8,0.2,0.1"}) {
        const Scene scene = ballOf(material);
        const glm::vec3 x = middleOf(gl::render(scene, light, camera(), options(16)));
        const glm::vec3 y = middleOf(trace::render(scene, light, camera(), options(64)));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(x[c], y[c], 0.04f * y[c]) << material;
    }
}

// trace's are in trace/rough_test.cpp. Half floats and the split sum's table: 1 %.
TEST(Finishes, LosslessOnesByNameAreInvisibleInUniformLight) {
    const Environment white = uniform();
    for (const char* material :
         {"mirror+rough:0.1", "mirror+rough:1", "glass+rough:0.2", "diamond+rough:0.7", "matt:1"}) {
        const glm::vec3 seen = middleOf(gl::render(ballOf(material), white, camera(), options(4)));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], 1.0f, 0.01f) << material;
    }
}

TEST(Finishes, ByNameIgnoreColoursOfVertices) {
    const Environment light = loadEnvironment("studio");
    for (const char* material : {"gold+rough:0.3", "glass+rough:0.3", "matt:0.8"}) {
        const Scene plain = ballOf(material);
        Scene coloured = plain;
        Mesh& mesh = coloured.parts[0].mesh;
        mesh.colors.assign(mesh.positions.size(), {0.1f, 0.9f, 0.2f, 1.0f});
        EXPECT_EQ(middleOf(gl::render(coloured, light, camera(), options(2))),
                  middleOf(gl::render(plain, light, camera(), options(2))));
        EXPECT_EQ(middleOf(trace::render(coloured, light, camera(), options(2))),
                  middleOf(trace::render(plain, light, camera(), options(2))));
    }
}

TEST(Finishes, GiveCoverageBesideGlass) {
    RenderOptions quick = options(4);
    quick.background = Background::none;
    Scene scene = mixed(true);
    scene.parts.erase(scene.parts.begin());
    const Image image = gl::render(scene, loadEnvironment("studio"), camera(), quick).radiance;
    EXPECT_EQ(image.alpha.front(), 0.0f);
    EXPECT_EQ(image.alpha[24 * 128 + 44], 1.0f);   // glass
    EXPECT_EQ(image.alpha[24 * 128 + 104], 1.0f);  // matt
}

}  // namespace
}  // namespace tukor
