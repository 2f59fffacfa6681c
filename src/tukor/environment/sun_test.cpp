#include "tukor/environment/sun.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/environment/equirect.h"
#include "tukor/environment/panorama.h"
#include "tukor/environment/procedural.h"

namespace tukor {
namespace {

/// A grey sky with a uniform disc.
Image discPanorama(glm::vec3 direction, float radius, float radiance) {
    CubeMap cube(256);
    for (const CubeFace face : kCubeFaces)
        for (glm::vec3& texel : cube.texels(face)) texel = glm::vec3(0.5f);
    addDisc(cube, direction, radius, glm::vec3(radiance));
    return panoramaFromCube(cube, 512);
}

TEST(FindSun, MeasuresADisc) {
    const glm::vec3 direction = glm::normalize(glm::vec3(0.3f, 0.6f, -0.7f));
    const float radius = 0.03f, radiance = 1000.0f;
    const std::optional<Sun> sun = findSun(discPanorama(direction, radius, radiance));
    ASSERT_TRUE(sun);
    EXPECT_LT(glm::length(sun->direction - direction), 1e-3f);  // a twelfth of a pixel
    EXPECT_NEAR(sun->angularRadius, radius,
                0.15f * radius);  // three pixels and the blur of the look-up
    const float solidAngle = 2 * std::numbers::pi_v<float> * (1 - std::cos(radius));
    EXPECT_NEAR(sun->irradiance.x, radiance * solidAngle, 0.03f * radiance * solidAngle);
    EXPECT_NEAR(sun->skyRadiance.x, 0.5f, 1e-3f);
}

TEST(FindSun, FindsNoneInAWideLightOrAnEvenSky) {
    EXPECT_FALSE(findSun(discPanorama({0, 1, 0.2f}, 0.3f, 1000.0f)));
    EXPECT_FALSE(findSun(discPanorama({0, 1, 0.2f}, 0.02f, 2.0f)));
    EXPECT_FALSE(findSun(Image(64, 32)));
}

TEST(FindSun, FindsNoneAmongTheLampsOfAStudio) {
    EXPECT_FALSE(findSun(panoramaFromCube(studioCube(128), 512)));
    EXPECT_TRUE(findSun(panoramaFromCube(skyCube(128), 512)));
}

TEST(WithoutSun, LeavesTheSky) {
    const Image image = discPanorama({0, 0.5f, -1}, 0.02f, 1000.0f);
    const std::optional<Sun> sun = findSun(image);
    ASSERT_TRUE(sun);
    const Image sky = withoutSun(image, *sun);
    for (const glm::vec3& pixel : sky.pixels()) EXPECT_LT(pixel.x, 1.1f);
}

TEST(SunText, HasItsFigures) {
    const Sun sun{{0, 1, 0}, kSunRadius, {1, 2, 3}, {0.5f, 0.5f, 0.5f}, 100.0f};
    EXPECT_EQ(jsonOf(sun),
              "{\n  \"direction\": [0, 1, 0],\n  \"angularRadiusDegrees\": 0.2666,\n"
              "  \"irradiance\": [1, 2, 3],\n  \"skyRadiance\": [0.5, 0.5, 0.5]\n}\n");
}

}  // namespace
}  // namespace tukor
