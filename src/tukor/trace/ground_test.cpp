// Ground: nothing but shadows and light on it, where they belong.
#include "tukor/trace/ground.h"

#include <numbers>

#include <gtest/gtest.h>

#include "tukor/geometry/sphere.h"
#include "tukor/scene/finish.h"
#include "tukor/trace/render.h"
#include "tukor/trace/test_scenes.h"

namespace tukor::trace {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

Scene ball(const Material& material, glm::vec3 centre) {
    Scene scene;
    Mesh mesh = makeSphere(24);
    for (glm::vec3& p : mesh.positions) p += centre;
    scene.parts.push_back({"ball", "", material, std::move(mesh)});
    return scene;
}

Material white() {
    Material m;
    m.tint = glm::vec3(1.0f);
    Finish finish;
    finish.metallic = 0.0f;
    m.finish = std::make_shared<Finish>(finish);
    return m;
}

RenderOptions onGround(int size, int samples) {
    RenderOptions options;
    options.width = options.height = size;
    options.samples = samples;
    options.ground = 0.0f;
    return options;
}

TEST(Ground, GetsPiOfUniformLight) {
    const glm::vec3 E = irradianceFromAbove(EnvironmentMap(constantCube(2.0f), 0.0f, 1.0f));
    EXPECT_NEAR(E.x, 2.0f * kPi, 1e-3f * kPi);
}

// Nothing shadows it: what is behind, without noise.
TEST(Ground, IsInvisibleWhereNothingIsNear) {
    const Scene scene = ball(metal(), {0, 1, 0});
    Camera camera = eyeAt({5, 1, 30});
    camera.target = {25, 0, 0};  // the ball is not in the picture, and low above the horizon
    RenderOptions options = onGround(16, 4);
    const Image with = render(scene, gradientCube(), camera, options).radiance;
    options.ground.reset();
    const Image without = render(scene, gradientCube(), camera, options).radiance;
    double sum = 0.0;
    for (std::size_t i = 0; i < with.pixels().size(); ++i)
        sum += std::abs(static_cast<double>(with.pixels()[i].x - without.pixels()[i].x));
    EXPECT_LT(sum / static_cast<double>(with.pixels().size()), 0.005);
}

// The white furnace on white ground. Noise: 64 samples of weights up to 1.
TEST(Ground, IsWhiteUnderWhiteThingsInUniformLight) {
    Material glass = clear(1.5f, 1);
    for (const Material& material : {white(), glass}) {
        const Image image = render(ball(material, {0, 1, 0}), constantCube(1.0f), eyeAt({0, 2, 5}),
                                   onGround(24, 64))
                                .radiance;
        glm::dvec3 sum(0.0);
        for (const glm::vec3& pixel : image.pixels()) {
            EXPECT_NEAR(pixel.x, 1.0f, 0.15f);
            sum += glm::dvec3(pixel);
        }
        EXPECT_NEAR(sum.x / static_cast<double>(image.pixels().size()), 1.0, 0.01);
    }
}

// Where no background is drawn, shadows cover it and light is added: over the background the same
// picture comes out.
TEST(Ground, CoversWhatIsNoBackground) {
    const Scene scene = ball(white(), {0, 1, 0});
    Camera camera = eyeAt({0, 2, 6});
    camera.target = {0, 0.5f, 0};
    RenderOptions options = onGround(24, 256);
    const Image whole = render(scene, constantCube(1.0f), camera, options).radiance;
    options.background = Background::none;
    const Image over = render(scene, constantCube(1.0f), camera, options).radiance;
    double sum = 0.0;
    int shadowed = 0;
    for (std::size_t i = 0; i < over.alpha.size(); ++i) {
        const float composed = over.pixels()[i].x + (1.0f - over.alpha[i]);
        EXPECT_NEAR(composed, whole.pixels()[i].x, 0.05f) << i;
        sum += static_cast<double>(composed - whole.pixels()[i].x);
        shadowed += over.alpha[i] > 0.05f && over.alpha[i] < 0.95f ? 1 : 0;
    }
    EXPECT_NEAR(sum / static_cast<double>(over.alpha.size()), 0.0, 2e-3);
    EXPECT_GT(shadowed, 20);
}

// A sun of 4 degrees in a weak sky: of each place on the ground geometry says whether a ball hides
// all of it, or none.
TEST(Ground, ShadowsLieWhereTheSunSaysSo) {
    const glm::vec3 sun = glm::normalize(glm::vec3(-0.6f, 0.8f, 0.25f));
    const float sunRadius = 0.035f;
    Image panorama(1024, 512);
    for (int row = 0; row < 512; ++row)
        for (int column = 0; column < 1024; ++column) {
            const float theta = kPi * (static_cast<float>(row) + 0.5f) / 512.0f;
            const float phi = 2.0f * kPi * ((static_cast<float>(column) + 0.5f) / 1024.0f - 0.5f);
            const glm::vec3 d(std::sin(theta) * std::sin(phi), std::cos(theta),
                              -std::sin(theta) * std::cos(phi));
            panorama.at(column, row) =
                glm::vec3(glm::dot(d, sun) > std::cos(sunRadius) ? 2000.0f : 0.2f);
        }
    const glm::vec3 centre(0, 1.5f, 0);
    Camera camera = eyeAt({3, 9, 3});
    camera.target = {1, 0, 0};
    const RenderOptions options = onGround(48, 64);
    Material dark = metal();
    dark.kind = MaterialKind::mirror;
    dark.tint = glm::vec3(0.0f);
    const Image image = render(ball(dark, centre), panorama, camera, options).radiance;
    const RayGenerator rays(camera, 48, 48);
    int shadowed = 0, lit = 0;
    for (int row = 0; row < 48; ++row)
        for (int column = 0; column < 48; ++column) {
            const glm::vec3 d = glm::normalize(
                rays.direction(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f));
            const auto nearness = [&](glm::vec3 from, glm::vec3 along) {
                return glm::length(glm::cross(centre - from, along));
            };
            if (nearness(camera.eye, d) < 1.15f) continue;  // the ball, or its rim
            const glm::vec3 place = camera.eye - d * (camera.eye.y / d.y);
            const float past = nearness(place, sun);
            const float penumbra = 2.5f * sunRadius + 0.2f;  // and a pixel
            if (past < 1.0f - penumbra) {
                ++shadowed;
                EXPECT_LT(image.at(column, row).x, 0.05f) << place.x << ' ' << place.z;
            } else if (past > 1.0f + penumbra) {
                ++lit;
                EXPECT_GT(image.at(column, row).x, 0.17f) << place.x << ' ' << place.z;
            }
        }
    EXPECT_GT(shadowed, 20);
    EXPECT_GT(lit, 500);
}

}  // namespace
}  // namespace tukor::trace
