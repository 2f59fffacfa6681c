// Pictures of surfaces with a finish: the white furnace, shadows, alpha, light and its absence.
#include <numbers>

#include <gtest/gtest.h>

#include "tukor/scene/finish.h"
#include "tukor/scene/material_text.h"
#include "tukor/trace/light_sampler.h"
#include "tukor/trace/render.h"
#include "tukor/trace/test_scenes.h"

namespace tukor::trace {
namespace {

Material finished(const Finish& finish) {
    Material m;
    m.finish = std::make_shared<Finish>(finish);
    return m;
}

Scene box(const Material& material, float half = 1.0f) {
    Scene scene;
    scene.parts.push_back({"box", "", material, boxMesh(glm::vec3(-half), glm::vec3(half))});
    return scene;
}

RenderOptions small(int samples) {
    RenderOptions options;
    options.width = options.height = 24;
    options.samples = samples;
    return options;
}

glm::vec3 meanOf(const Image& image) {
    glm::dvec3 sum(0.0);
    for (const glm::vec3 pixel : image.pixels()) sum += glm::dvec3(pixel);
    return glm::vec3(sum / static_cast<double>(image.pixels().size()));
}

// The mean of 1 / pdf over samples is the measure of the sphere, of f / pdf the integral of f: here
// of a squared cosine, 4 pi / 3. A tenth of white in the map keeps the weights below 11; 65536
// well-distributed samples leave less than 0.3 %.
TEST(LightSampler, SamplesWithTheDensityThatItTells) {
    Image panorama(64, 32);
    for (std::size_t i = 0; i < panorama.pixels().size(); ++i)
        panorama.pixels()[i] = glm::vec3(i * 2654435761u % 37 == 0 ? 10.0f : 1.0f);
    const EnvironmentMap map(panorama, 0.3f, 1.0f);
    const LightSampler lights(map);
    constexpr std::uint32_t kSamples = 65536;
    double measure = 0.0, squares = 0.0;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        const LightDirection light = lights.sample(transport::pixelSample(5u, i));
        ASSERT_GT(light.pdf, 0.0f);
        EXPECT_NEAR(lights.pdf(light.direction) / light.pdf, 1.0f, 0.02f);
        measure += 1.0 / light.pdf / kSamples;
        squares += light.direction.x * light.direction.x / light.pdf / kSamples;
    }
    EXPECT_NEAR(measure / (4.0 * std::numbers::pi), 1.0, 0.003);
    EXPECT_NEAR(squares / (4.0 * std::numbers::pi / 3.0), 1.0, 0.003);
}

// Every pixel is 1 in the mean, whatever is in front of it: 1 % by the tables, the rest is noise of
// 24 x 24 x 64 samples whose weights differ by at most 2.
TEST(RoughEvent, WhiteSurfacesVanishInUniformLight) {
    for (const float metallic : {0.0f, 1.0f})
        for (const float roughness : {0.2f, 0.6f, 1.0f}) {
            Finish finish;
            finish.metallic = metallic;
            finish.roughness = roughness;
            const Rendering picture = render(box(finished(finish)), constantCube(1.0f),
                                             eyeAt({2.0f, 3.0f, 4.0f}), small(64));
            const glm::vec3 mean = meanOf(picture.radiance);
            EXPECT_NEAR(mean.x, 1.0f, 0.012f) << metallic << ' ' << roughness;
            EXPECT_NEAR(mean.z, 1.0f, 0.012f) << metallic << ' ' << roughness;
        }
}

TEST(RoughEvent, RoughGlassVanishesInUniformLight) {
    Finish finish;
    finish.metallic = 0.0f;
    finish.transmission = 1.0f;
    for (const float roughness : {0.1f, 0.5f, 1.0f}) {
        finish.roughness = roughness;
        Material material = finished(finish);
        material.kind = MaterialKind::dielectric;
        const Rendering picture =
            render(box(material), constantCube(1.0f), eyeAt({2.0f, 3.0f, 4.0f}), small(64));
        EXPECT_NEAR(meanOf(picture.radiance).y, 1.0f, 0.012f) << roughness;
        EXPECT_EQ(picture.leaks, 0u);
    }
}

// By the same tolerance. A tinted mirror shows its tint, whatever the angle: one pixel's noise, and
// what facets reflect twice, are less than 0.05.
TEST(RoughEvent, LosslessMaterialsByNameVanishInUniformLight) {
    const auto mean = [](std::string_view material) {
        return meanOf(render(box(materialFromText(material)), constantCube(1.0f),
                             eyeAt({2.0f, 3.0f, 4.0f}), small(64))
                          .radiance);
    };
    for (const char* material : {"mirror+rough:0.1", "mirror+rough:0.6", "glass+rough:0.2",
                                 "diamond+rough:0.3", "water+rough:1", "matt:1"}) {
        const glm::vec3 seen = mean(material);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], 1.0f, 0.012f) << material;
    }
    const Camera close = eyeAt({0.0f, 0.0f, 2.0f});  // sees nothing but one side
    for (const float roughness : {0.1f, 0.5f}) {
        const auto text = "mirror:0.8,0.4,0.6+rough:" + std::to_string(roughness);
        const Scene scene = box(materialFromText(text));
        const glm::vec3 seen =
            render(scene, constantCube(1.0f), close, small(64)).radiance.at(12, 12);
        EXPECT_NEAR(seen.x, 0.8f, 0.05f) << text;
        EXPECT_NEAR(seen.y, 0.4f, 0.05f) << text;
        EXPECT_NEAR(seen.z, 0.6f, 0.05f) << text;
    }
}

TEST(RoughEvent, DiffuseSurfacesShowTheirColourAndWhatShadesThem) {
    Finish finish;
    finish.metallic = 0.0f;
    finish.specular = 0.0f;
    finish.baseColor = {0.8f, 0.4f, 0.2f};
    Scene scene = box(finished(finish));
    const Rendering open = render(scene, constantCube(2.0f), eyeAt({0, 0, 3}), small(64));
    const glm::vec3 middle = open.radiance.at(12, 12);
    EXPECT_NEAR(middle.x, 1.6f, 0.05f);
    EXPECT_NEAR(middle.y, 0.8f, 0.03f);
    EXPECT_NEAR(middle.z, 0.4f, 0.02f);
    // A black lid over half of what the front sees.
    Finish black;
    black.baseColor = glm::vec3(0.0f);
    black.metallic = 0.0f;
    black.specular = 0.0f;
    scene.parts.push_back(
        {"lid", "", finished(black), boxMesh({-50.0f, 1.001f, -1.0f}, {50.0f, 1.002f, 100.0f})});
    const Rendering shaded = render(scene, constantCube(2.0f), eyeAt({0, 0, 3}), small(64));
    EXPECT_LT(shaded.radiance.at(12, 2).x, 0.65f * open.radiance.at(12, 2).x);
}

TEST(RoughEvent, AlphaLetsThroughItsShare) {
    Finish finish;
    finish.unlit = true;
    finish.alphaMode = AlphaMode::blend;
    finish.alpha = 0.25f;
    finish.baseColor = glm::vec3(0.0f);
    Scene scene;
    scene.parts.push_back({"sheet", "", finished(finish), boxMesh({-9, -9, -0.01f}, {9, 9, 0})});
    // Two sides of the box: 0.75 of 0.75.
    const Rendering picture = render(scene, constantCube(1.0f), eyeAt({0, 0, 3}), small(256));
    EXPECT_NEAR(meanOf(picture.radiance).y, 0.5625f, 0.01f);
    finish.alphaMode = AlphaMode::mask;
    scene.parts[0].material = finished(finish);
    EXPECT_EQ(meanOf(render(scene, constantCube(1.0f), eyeAt({0, 0, 3}), small(2)).radiance).y,
              1.0f);
}

TEST(RoughEvent, EmittedLightIsSeenAndLightsOthers) {
    Finish lamp;
    lamp.metallic = 0.0f;
    lamp.baseColor = glm::vec3(0.0f);
    lamp.specular = 0.0f;
    lamp.emission = {3.0f, 2.0f, 1.0f};
    Scene scene = box(finished(lamp));
    const CubeMap dark = constantCube(0.0f);
    EXPECT_NEAR(render(scene, dark, eyeAt({0, 0, 3}), small(4)).radiance.at(12, 12).y, 2.0f, 1e-5f);
    Finish wall;
    wall.metallic = 0.0f;
    wall.specular = 0.0f;
    scene.parts.push_back({"wall", "", finished(wall), boxMesh({-1, -1, 2}, {1, 1, 2.1f})});
    Camera camera = eyeAt({0.0f, 0.0f, 1.5f});
    camera.target = {0, 0, 2};
    EXPECT_GT(render(scene, dark, camera, small(64)).radiance.at(12, 12).x, 0.3f);
}

TEST(RoughEvent, LampsLightWhatTheySeeByTheirIrradiance) {
    Finish matt;
    matt.metallic = 0.0f;
    matt.specular = 0.0f;
    Scene scene = box(finished(matt));
    Light sun;
    sun.direction = {0, 0, -1};
    sun.intensity = glm::vec3(3.1415927f);
    scene.lights.push_back(sun);
    const CubeMap dark = constantCube(0.0f);
    EXPECT_NEAR(render(scene, dark, eyeAt({0, 0, 3}), small(16)).radiance.at(12, 12).y, 1.0f,
                1e-3f);
    scene.parts.push_back({"screen", "", finished(matt), boxMesh({-5, -5, 4}, {5, 5, 4.1f})});
    EXPECT_EQ(render(scene, dark, eyeAt({0, 0, 3}), small(16)).radiance.at(12, 12).y, 0.0f);
}

}  // namespace
}  // namespace tukor::trace
