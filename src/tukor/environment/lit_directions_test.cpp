// The light on ground as a list of directions: all of it, and where it comes from.
#include "tukor/environment/lit_directions.h"

#include <array>
#include <numbers>

#include <gtest/gtest.h>

#include "tukor/environment/environment.h"
#include "tukor/environment/panorama.h"

namespace tukor {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

glm::vec3 irradianceOf(const std::vector<LitDirection>& all) {
    glm::dvec3 sum(0.0);
    for (const LitDirection& one : all) sum += glm::dvec3(one.irradiance);
    return glm::vec3(sum);
}

TEST(LitDirections, ArePiOfUniformLight) {
    Image panorama(64, 32);
    for (glm::vec3& pixel : panorama.pixels()) pixel = {1.0f, 2.0f, 0.5f};
    CubeMap cube(16);
    for (const CubeFace face : kCubeFaces)
        for (glm::vec3& texel : cube.texels(face)) texel = {1.0f, 2.0f, 0.5f};
    for (const auto& all : {litDirections(panorama, {}, 256), litDirections(cube, {}, 256)}) {
        ASSERT_EQ(all.size(), 256u);
        const glm::vec3 E = irradianceOf(all);
        EXPECT_NEAR(E.x, kPi, 5e-3f * kPi);
        EXPECT_NEAR(E.y, 2.0f * kPi, 1e-2f * kPi);
        // An eighth of them says the same of where light comes from: from all sides.
        glm::vec3 mean(0.0f);
        for (int i = 64; i < 96; ++i) mean += all[static_cast<std::size_t>(i)].direction / 32.0f;
        EXPECT_NEAR(mean.x, 0.0f, 0.2f);
        EXPECT_NEAR(mean.y, 2.0f / 3.0f, 0.05f);  // mean of the cosine, weighted by it
        EXPECT_NEAR(mean.z, 0.0f, 0.2f);
    }
}

TEST(LitDirections, PanoramaAndItsCubeMapLightAlike) {
    const Environment sky = builtInEnvironment("sky").value();
    const glm::vec3 a = irradianceOf(litDirections(sky.radiance, {}, 4096));
    const glm::vec3 b = irradianceOf(litDirections(panoramaFromCube(sky.radiance, 2048), {}, 4096));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 2e-3f * a[c]);
}

TEST(LitDirections, GiveLampsTheirShare) {
    Image panorama(64, 32);
    for (glm::vec3& pixel : panorama.pixels()) pixel = glm::vec3(1.0f);
    const std::array lamp{LitDirection{glm::vec3(0.6f, 0.8f, 0.0f), glm::vec3(kPi)}};
    int ofLamp = 0;
    for (const LitDirection& one : litDirections(panorama, lamp, 1024))
        ofLamp += one.direction == lamp[0].direction ? 1 : 0;
    EXPECT_NEAR(ofLamp, 512, 2);
    EXPECT_TRUE(litDirections(Image(8, 4), {}, 64).empty()) << "darkness lights nothing";
}

}  // namespace
}  // namespace tukor
