#include "tukor/environment/procedural.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tukor/environment/cube_mips.h"
#include "tukor/environment/cube_texel.h"

namespace tukor {
namespace {

glm::dvec3 integral(const CubeMap& cube) {
    const std::vector<float> angles = faceSolidAngles(cube.faceSize());
    glm::dvec3 sum(0.0);
    for (const CubeFace face : kCubeFaces)
        for (std::size_t i = 0; i < angles.size(); ++i)
            sum += static_cast<double>(angles[i]) * glm::dvec3(cube.texels(face)[i]);
    return sum;
}

glm::vec2 range(const CubeMap& cube) {
    glm::vec2 range(1e30f, -1e30f);
    for (const CubeFace face : kCubeFaces)
        for (const glm::vec3& texel : cube.texels(face))
            for (int i = 0; i < 3; ++i)
                range = {std::min(range.x, texel[i]), std::max(range.y, texel[i])};
    return range;
}

/// Relative root mean square difference.
double difference(const CubeMap& a, const CubeMap& b) {
    double error = 0, size = 0;
    for (const CubeFace face : kCubeFaces)
        for (std::size_t i = 0; i < a.texels(face).size(); ++i) {
            const glm::vec3 delta = a.texels(face)[i] - b.texels(face)[i];
            error += static_cast<double>(glm::dot(delta, delta));
            size += static_cast<double>(glm::dot(b.texels(face)[i], b.texels(face)[i]));
        }
    return std::sqrt(error / size);
}

TEST(AddDisc, KeepsItsIntegralAtEveryResolutionAndPlace) {
    const float radius = kSunRadius;
    const double solidAngle = 2 * std::numbers::pi * (1 - std::cos(static_cast<double>(radius)));
    const glm::vec3 places[] = {{1, 0, 0}, {1, 1, 1}, {0, 1, 1}, {0.3f, 0.5f, -0.7f}};
    for (const int size : {1, 4, 64, 256})
        for (const glm::vec3 place : places) {
            CubeMap cube(size);
            addDisc(cube, place, radius, {1000.0f, 500.0f, 0.0f});
            EXPECT_NEAR(integral(cube).x / (1000.0 * solidAngle), 1.0, 1e-4) << size;
            EXPECT_NEAR(integral(cube).y / (500.0 * solidAngle), 1.0, 1e-4) << size;
        }
}

TEST(AddDisc, CoversItsTexelsAndNoOthers) {
    CubeMap cube(128);
    addDisc(cube, {0, 0, 1}, 0.2f, glm::vec3(1.0f));
    for (const CubeFace face : kCubeFaces)
        for (int row = 0; row < 128; ++row)
            for (int column = 0; column < 128; ++column) {
                const float angle =
                    std::acos(glm::normalize(directionFromTexel({face, column, row}, 128)).z);
                const float value =
                    cube.texels(face)[static_cast<std::size_t>(row * 128 + column)].x;
                // A texel's half diagonal is 0.011.
                if (angle > 0.2f + 0.012f) {
                    EXPECT_EQ(value, 0.0f);
                }
                if (angle < 0.2f - 0.012f) {
                    EXPECT_NEAR(value, 1.0f, 1e-3f);
                }
            }
}

TEST(SkyCube, SendsTheSameLightAtEveryResolution) {
    const glm::dvec3 fine = integral(skyCube(256));
    for (const int size : {16, 64}) {
        const glm::dvec3 coarse = integral(skyCube(size));
        // The sun is exact; the sky is sampled once a texel where it is smooth.
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(coarse[i] / fine[i], 1.0, 5e-3) << size;
    }
}

TEST(SkyCube, ShinesFromItsSun) {
    SkyOptions options;
    options.sunElevation = 0.3f;
    options.sunAzimuth = -1.0f;
    const CubeMap cube = skyCube(128, options);
    const float atSun = cube.radiance(sunDirection(options)).x;
    EXPECT_EQ(atSun, atSun);
    EXPECT_GT(atSun, 1000.0f);
    EXPECT_NEAR(sunDirection(options).y, std::sin(0.3f), 1e-6f);
    EXPECT_LT(cube.radiance(-sunDirection(options)).x, 2.0f);
}

TEST(SkyCube, FitsHalfFloatsAndIsNeverNegative) {
    for (const float elevation : {0.02f, 0.65f, 1.5707963f}) {
        SkyOptions options;
        options.sunElevation = elevation;
        const glm::vec2 values = range(skyCube(512, options));
        EXPECT_GE(values.x, 0.0f) << elevation;
        EXPECT_LT(values.y, 65504.0f) << elevation;
    }
}

TEST(StudioCube, HasLightsOfTheirStatedRange) {
    const glm::vec2 values = range(studioCube(256));
    EXPECT_GE(values.x, 0.0f);
    EXPECT_LT(values.x, 0.05f);
    EXPECT_NEAR(values.y, 20.0f, 0.1f);
}

TEST(StudioCube, IsAreaSampled) {
    // The same texels, whether the lights' edges are averaged in the function or by shrinking.
    EXPECT_LT(difference(studioCube(64), shrunkCube(studioCube(512), 64)), 0.02);
}

}  // namespace
}  // namespace tukor
