#include "tukor/gl/renderer.h"

#include <gmock/gmock.h>

#include "tukor/base/error.h"
#include "tukor/environment/procedural.h"
#include "tukor/geometry/sphere.h"
#include "tukor/gl/context.h"
#include "tukor/gl/render.h"

namespace tukor::gl {
namespace {

using testing::HasSubstr;

constexpr int kWidth = 96;
constexpr int kHeight = 54;

Scene sphereOf(const Material& material) {
    Scene scene;
    scene.parts.push_back({"sphere", "", material, makeSphere(40)});
    return scene;
}

Environment studio() {
    return {"studio", studioCube(64), {}};
}

Environment uniform(glm::vec3 radiance) {
    Environment environment{"uniform", CubeMap(4), {}};
    for (const CubeFace face : kCubeFaces)
        for (glm::vec3& texel : environment.radiance.texels(face)) texel = radiance;
    return environment;
}

Material glass() {
    Material material;
    material.kind = MaterialKind::dielectric;
    material.eta = glm::vec3(1.46f);
    return material;
}

RenderOptions small() {
    RenderOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.samples = 16;
    options.fidelity = Fidelity::single;
    return options;
}

float largestDifference(const Image& a, const Image& b) {
    float largest = 0.0f;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const glm::vec3 d = glm::abs(glm::min(a.pixels()[i], glm::vec3(1.0f)) -
                                     glm::min(b.pixels()[i], glm::vec3(1.0f)));
        largest = std::max({largest, d.x, d.y, d.z});
    }
    return largest;
}

Camera tilted() {
    Camera camera;
    camera.eye = {2.0f, 1.5f, 3.0f};
    return camera;
}

TEST(Renderer, DrawsTheSameBackgroundAsQuadBoxAndDomeFirstOrLast) {
    const Context context;
    Renderer renderer;
    renderer.setScene(sphereOf(glass()));
    renderer.setEnvironment(studio());
    const auto drawn = [&](Background background, BackgroundOrder order) {
        FrameOptions options;
        options.picture = small();
        options.picture.background = background;
        options.picture.environmentRotation = 0.7f;
        options.backgroundOrder = order;
        renderer.drawFrame(tilted(), options);
        return renderer.read().radiance;
    };
    const Image quad = drawn(Background::quad, BackgroundOrder::last);
    for (const Background background : {Background::quad, Background::box, Background::dome})
        for (const BackgroundOrder order : {BackgroundOrder::first, BackgroundOrder::last})
            EXPECT_LT(largestDifference(quad, drawn(background, order)), 1.0f / 255.0f);
}

TEST(Renderer, DrawsTheEnvironmentWhereTheCameraLooks) {
    RenderOptions options = small();
    for (const float angle : {0.0f, 0.7f, 3.0f}) {
        options.environmentRotation = angle;
        const Environment environment = studio();
        const Image image = render({}, environment, tilted(), options).radiance;
        // Turned by the angle about +Y, counter-clockwise from above: what lay at d lies at R d.
        const glm::mat3 back(std::cos(angle), 0.0f, std::sin(angle), 0.0f, 1.0f, 0.0f,
                             -std::sin(angle), 0.0f, std::cos(angle));
        // +Z goes to +X in a quarter turn counter-clockwise.
        EXPECT_GT((glm::transpose(back) * glm::vec3(0, 0, 1)).x, angle == 0.0f ? -1.0f : 0.0f);
        double sum = 0.0;
        for (int row = 0; row < kHeight; ++row) {
            for (int column = 0; column < kWidth; ++column) {
                const glm::vec3 d =
                    rayDirection(tilted(), kWidth, kHeight, static_cast<float>(column) + 0.5f,
                                 static_cast<float>(row) + 0.5f);
                const glm::vec3 expected = environment.radiance.radiance(back * d);
                const glm::vec3 difference = glm::min(image.at(column, row), glm::vec3(1.0f)) -
                                             glm::min(expected, glm::vec3(1.0f));
                sum += glm::dot(difference, difference) / 3.0f;
            }
        }
        // The mean over a pixel against its middle: edges of lights differ.
        EXPECT_LT(std::sqrt(sum / (kWidth * kHeight)), 0.03) << angle;
    }
}

TEST(Renderer, ShowsClearMatterInUniformLightAsNothing) {
    // R + T = 1 at every fragment: rows 4 and 11.
    const Image image =
        render(sphereOf(glass()), uniform(glm::vec3(0.5f, 1.0f, 2.0f)), tilted(), small()).radiance;
    for (const glm::vec3& pixel : image.pixels())
        ASSERT_LT(glm::length(pixel - glm::vec3(0.5f, 1.0f, 2.0f)), 2e-3f);  // half-float frames
}

TEST(Renderer, ShowsLampsWhereTheEnvironmentHasNoIntensity) {
    Material clay;
    Finish matt;
    matt.metallic = 0.0f;
    clay.finish = std::make_shared<Finish>(matt);
    Scene scene = sphereOf(clay);
    Light lamp;
    lamp.intensity = glm::vec3(2.0f);
    scene.lights.push_back(lamp);
    RenderOptions options = small();
    const Image black = render(scene, uniform(glm::vec3(0.0f)), Camera{}, options).radiance;
    options.environmentIntensity = 0.0f;
    const Image dark = render(scene, uniform(glm::vec3(5.0f)), Camera{}, options).radiance;
    EXPECT_LT(largestDifference(dark, black), 1e-6f);
    EXPECT_GT(dark.at(kWidth / 2, kHeight / 2).x, 0.3f);
    EXPECT_EQ(dark.at(0, 0), glm::vec3(0.0f));
}

TEST(Renderer, KeepsSunsBrighterThanHalfFloats) {
    const Image image =
        render(sphereOf(Material{}), uniform(glm::vec3(1e6f)), Camera{}, small()).radiance;
    EXPECT_NEAR(image.at(kWidth / 2, kHeight / 2).x, 1e6f, 1e3f);
    EXPECT_NEAR(image.at(0, 0).x, 1e6f, 1e3f);
}

TEST(Renderer, GivesCoverageWhereThereIsNoBackground) {
    RenderOptions options = small();
    options.background = Background::none;
    const Image image =
        render(sphereOf(Material{}), uniform(glm::vec3(1.0f)), Camera{}, options).radiance;
    ASSERT_EQ(image.alpha.size(), image.pixels().size());
    EXPECT_EQ(image.alpha.front(), 0.0f);
    EXPECT_EQ(image.at(0, 0), glm::vec3(0.0f));
    EXPECT_EQ(image.alpha[kHeight / 2 * kWidth + kWidth / 2], 1.0f);
    bool partial = false;
    for (std::size_t i = 0; i < image.alpha.size(); ++i) {
        partial = partial || (image.alpha[i] > 0.1f && image.alpha[i] < 0.9f);
        ASSERT_NEAR(image.pixels()[i].x, image.alpha[i], 2e-3f);
    }
    EXPECT_TRUE(partial);
}

TEST(Renderer, BlursWhatLiesBehindTheSceneAlone) {
    const Context context;
    Renderer renderer;
    renderer.setScene(sphereOf(glass()));
    for (const Fidelity fidelity : {Fidelity::single, Fidelity::exact}) {
        FrameOptions options;
        options.picture = small();
        options.picture.fidelity = fidelity;
        const auto drawn = [&](Background background, float blur) {
            options.picture.background = background;
            options.picture.backgroundBlur = blur;
            for (int i = 0; i < 2; ++i) renderer.drawFrame(tilted(), options);
            return renderer.read().radiance;
        };
        renderer.setEnvironment(studio());
        const Image bare = drawn(Background::none, 0.0f);
        const Image sharp = drawn(Background::quad, 0.0f);
        const Image blurred = drawn(Background::quad, 1.0f);
        EXPECT_TRUE(blurred.alpha.empty());
        int inside = 0;
        float steepest = 0.0f;
        for (int i = 1; i < kWidth * kHeight; ++i) {
            const glm::vec3 here = blurred.pixels()[i], before = blurred.pixels()[i - 1];
            if (bare.alpha[i] == 1.0f) {
                ++inside;
                EXPECT_LT(glm::distance(here, sharp.pixels()[i]), 1e-4f * glm::length(here));
            } else if (bare.alpha[i] == 0.0f && bare.alpha[i - 1] == 0.0f && i % kWidth != 0) {
                steepest = std::max(steepest, glm::distance(here, before) / glm::length(here));
            }
        }
        EXPECT_GT(inside, 100);
        // Irradiance is the integral against a cosine: over a pixel of 0.01 it changes by little.
        EXPECT_LT(steepest, 0.05f);

        // Of uniform light nothing is to be seen; half floats are right to 2^-11.
        renderer.setEnvironment(uniform({0.25f, 0.5f, 1.0f}));
        const Image even = drawn(Background::quad, 0.5f);
        for (const glm::vec3 pixel : even.pixels())
            EXPECT_LT(glm::distance(pixel, glm::vec3(0.25f, 0.5f, 1.0f)), 2e-3f);
    }
}

TEST(Renderer, PutsWindowsOfAPictureTogether) {
    const Context context;
    Renderer renderer;
    renderer.setScene(sphereOf(glass()));
    renderer.setEnvironment(studio());
    FrameOptions options;
    options.picture = small();
    renderer.drawFrame(tilted(), options);
    const Image whole = renderer.read().radiance;
    renderer.drawFrame(tilted(), options, {kWidth, kHeight, 40, 10, 32, 24});
    const Image part = renderer.read().radiance;
    float largest = 0.0f;
    for (int row = 0; row < 24; ++row)
        for (int column = 0; column < 32; ++column)
            largest = std::max(largest,
                               glm::length(glm::min(part.at(column, row), glm::vec3(1.0f)) -
                                           glm::min(whole.at(40 + column, kHeight - 10 - 24 + row),
                                                    glm::vec3(1.0f))));
    EXPECT_LT(largest, 0.02f);
}

TEST(Renderer, AccumulatesUntilSomethingChanges) {
    const Context context;
    Renderer renderer;
    renderer.setScene(sphereOf(glass()));
    renderer.setEnvironment(studio());
    FrameOptions options;
    options.picture = small();
    renderer.drawFrame(Camera{}, options);
    renderer.drawFrame(Camera{}, options);
    EXPECT_EQ(renderer.accumulatedSamples(), 8);
    renderer.drawFrame(tilted(), options);
    EXPECT_EQ(renderer.accumulatedSamples(), 4);
    renderer.drawFrame(tilted(), options);
    renderer.setMaterial(0, Material{});
    EXPECT_EQ(renderer.accumulatedSamples(), 0);
    renderer.drawFrame(tilted(), options);
    options.picture.fresnel = FresnelForm::schlick;
    renderer.drawFrame(tilted(), options);
    EXPECT_EQ(renderer.accumulatedSamples(), 4);
}

TEST(Renderer, ComparesTwoWaysSideBySide) {
    const Context context;
    Renderer renderer;
    Material metal;
    metal.kind = MaterialKind::metal;
    metal.eta = glm::vec3(1.3f, 0.9f, 0.6f);  // aluminium: the approximation is far off
    metal.k = glm::vec3(7.5f, 6.4f, 5.3f);
    renderer.setScene(sphereOf(metal));
    renderer.setEnvironment(studio());
    FrameOptions options;
    options.picture = small();
    const auto drawn = [&] {
        renderer.drawFrame(tilted(), options);
        return renderer.read().radiance;
    };
    const Image exact = drawn();
    options.comparison = Comparison{0.5f, Fidelity::single, FresnelForm::schlick};
    const Image both = drawn();
    options.comparison.reset();
    options.picture.fresnel = FresnelForm::schlick;
    const Image schlick = drawn();
    for (int row = 0; row < kHeight; ++row)
        for (int column = 0; column < kWidth; ++column)
            ASSERT_EQ(both.at(column, row),
                      (column < kWidth / 2 ? exact : schlick).at(column, row));
    EXPECT_GT(largestDifference(exact, schlick), 0.01f);
}

TEST(Renderer, PresentsWhatTheImageModuleDisplays) {
    const Context context;
    Renderer renderer;
    renderer.setScene(sphereOf(glass()));
    renderer.setEnvironment(studio());
    FrameOptions options;
    options.picture = small();
    renderer.drawFrame(tilted(), options);
    const Image radiance = renderer.read().radiance;

    const Texture target = Texture::make();
    glBindTexture(GL_TEXTURE_2D, target.id());
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, kWidth, kHeight);
    const Framebuffer framebuffer = Framebuffer::make();
    for (const Tonemap tonemap :
         {Tonemap::none, Tonemap::reinhard, Tonemap::aces, Tonemap::agx, Tonemap::neutral}) {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.id(), 0);
        renderer.present({.exposureStops = 0.5f, .tonemap = tonemap}, {0, 0, kWidth, kHeight});
        std::vector<std::uint8_t> bytes(4 * kWidth * kHeight);
        glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        for (int row = 0; row < kHeight; ++row) {
            for (int column = 0; column < kWidth; ++column) {
                const glm::vec3 shown =
                    displayed(radiance.at(column, row), tonemap, std::exp2(0.5f));
                const std::size_t at =
                    4 * (static_cast<std::size_t>(kHeight - 1 - row) * kWidth + column);
                for (int i = 0; i < 3; ++i)
                    ASSERT_NEAR(bytes[at + static_cast<std::size_t>(i)], srgb8(shown[i]), 1)
                        << column << ", " << row;
            }
        }
    }
}

TEST(Render, StopsWhenToldAndKeepsWhatItHas) {
    RenderOptions options = small();
    options.samples = 4000;
    int calls = 0;
    const Rendering rendering = render(sphereOf(glass()), uniform(glm::vec3(1.0f)), Camera{},
                                       options, [&](float, std::uint64_t) { return ++calls < 2; });
    EXPECT_EQ(calls, 2);
    EXPECT_NEAR(rendering.radiance.at(0, 0).x, 1.0f, 1e-3f);
}

}  // namespace
}  // namespace tukor::gl
