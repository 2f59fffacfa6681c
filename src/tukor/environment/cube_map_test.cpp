#include "tukor/environment/cube_map.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tukor/environment/cube_mips.h"
#include "tukor/environment/cube_texel.h"

namespace tukor {
namespace {

constexpr unsigned kSeed = 20261122;

CubeMap randomCube(int faceSize) {
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<float> value(0.0f, 2.0f);
    CubeMap cube(faceSize);
    for (const CubeFace face : kCubeFaces)
        for (glm::vec3& texel : cube.texels(face))
            texel = {value(random), value(random), value(random)};
    return cube;
}

glm::vec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<float> normal;
    return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
}

float distance(glm::vec3 a, glm::vec3 b) {
    return glm::length(a - b);
}

TEST(CubeFace, LooksAlongTheAxesOfTheTable) {
    struct Row {
        CubeFace face;
        glm::vec3 axis, s, t;
    };
    const Row table[] = {
        {CubeFace::posX, {1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
        {CubeFace::negX, {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
        {CubeFace::posY, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
        {CubeFace::negY, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
        {CubeFace::posZ, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
        {CubeFace::negZ, {0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
    };
    for (const Row& row : table) {
        EXPECT_EQ(directionFromCube({row.face, 0, 0}), row.axis);
        EXPECT_EQ(directionFromCube({row.face, 1, 0}) - row.axis, row.s);
        EXPECT_EQ(directionFromCube({row.face, 0, 1}) - row.axis, row.t);
    }
}

TEST(CubeFromDirection, FindsTheTexelThatEveryCentreCameFrom) {
    for (const int size : {1, 2, 3, 16, 101})
        for (const CubeFace face : kCubeFaces)
            for (int row = 0; row < size; ++row)
                for (int column = 0; column < size; ++column) {
                    const glm::vec3 direction = directionFromTexel({face, column, row}, size);
                    const CubePoint point = cubeFromDirection(3.7f * direction);
                    EXPECT_EQ(point.face, face);
                    EXPECT_EQ(static_cast<int>(0.5f * (point.s + 1) * static_cast<float>(size)),
                              column);
                    EXPECT_EQ(static_cast<int>(0.5f * (point.t + 1) * static_cast<float>(size)),
                              row);
                }
}

TEST(CubeFromDirection, RoundTripsInsideAndOnEveryEdgeAndCorner) {
    for (const CubeFace face : kCubeFaces)
        for (float s = -1.0f; s <= 1.0f; s += 0.125f)
            for (float t = -1.0f; t <= 1.0f; t += 0.125f) {
                // On an edge another face may answer, but with the same direction.
                const glm::vec3 direction = directionFromCube({face, s, t});
                const glm::vec3 back = directionFromCube(cubeFromDirection(direction));
                EXPECT_EQ(back, direction) << int(face) << ' ' << s << ' ' << t;
            }
}

TEST(TexelAcrossEdge, IsTheTexelNearestToTheFoldedPlace) {
    for (const int size : {2, 5, 8})
        for (const CubeFace face : kCubeFaces)
            for (int along = 0; along < size; ++along)
                for (const CubeTexel outside :
                     {CubeTexel{face, -1, along}, CubeTexel{face, size, along},
                      CubeTexel{face, along, -1}, CubeTexel{face, along, size}}) {
                    const CubeTexel across = texelAcrossEdge(outside, size);
                    EXPECT_NE(across.face, face);
                    const CubePoint seen = cubeFromDirection(directionFromTexel(outside, size));
                    const auto texel = [&](float x) {
                        return static_cast<int>(0.5f * (x + 1) * static_cast<float>(size));
                    };
                    EXPECT_EQ(across, (CubeTexel{seen.face, texel(seen.s), texel(seen.t)}));
                }
}

TEST(TexelAcrossEdge, LeadsBackFromTheNeighbour) {
    const int size = 4;
    for (const CubeFace face : kCubeFaces)
        for (int depth = 0; depth < size; ++depth) {
            // As deep beyond the edge as the place that the neighbour sees the same way.
            const CubeTexel across = texelAcrossEdge({face, size + depth, 1}, size);
            const glm::vec3 direction = directionFromTexel(across, size);
            const glm::vec3 edge = directionFromCube({face, 1.0f, -0.25f});
            EXPECT_NEAR(glm::length(direction - edge),
                        (2.0f * static_cast<float>(depth) + 1.0f) / 4, 1e-6f);
        }
}

TEST(TexelSolidAngle, SumsToTheWholeSphere) {
    for (const int size : {1, 2, 7, 64}) {
        double sum = 0;
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) sum += texelSolidAngle(size, column, row);
        EXPECT_NEAR(6 * sum, 4 * std::numbers::pi, 1e-11);
    }
}

TEST(FaceSolidAngles, AreThoseOfTheSingleTexels) {
    for (const int size : {1, 2, 5, 32}) {
        const std::vector<float> angles = faceSolidAngles(size);
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column)
                EXPECT_NEAR(angles[static_cast<std::size_t>(row * size + column)],
                            texelSolidAngle(size, column, row), 1e-7);
    }
}

TEST(CubeMapRadiance, IsTheTexelAtItsCentre) {
    for (const int size : {1, 2, 9}) {
        const CubeMap cube = randomCube(size);
        for (const CubeFace face : kCubeFaces)
            for (int row = 0; row < size; ++row)
                for (int column = 0; column < size; ++column)
                    EXPECT_LT(
                        distance(cube.radiance(directionFromTexel({face, column, row}, size)),
                                 cube.texels(face)[static_cast<std::size_t>(row * size + column)]),
                        1e-5f);
    }
}

TEST(CubeMapRadiance, IsBilinearBetweenFourCentres) {
    const CubeMap cube = randomCube(4);
    const auto texels = cube.texels(CubeFace::posX);
    // Half way between columns 1 and 2, a quarter of the way from row 1 to row 2.
    const glm::vec3 expected =
        0.75f * 0.5f * (texels[5] + texels[6]) + 0.25f * 0.5f * (texels[9] + texels[10]);
    EXPECT_LT(distance(cube.radiance(directionFromCube({CubeFace::posX, 0.0f, -0.125f})), expected),
              1e-6f);
}

TEST(CubeMapRadiance, AveragesThreeTexelsAtACornerOfTheCube) {
    const CubeMap cube = randomCube(4);
    const glm::vec3 expected = (cube.texels(CubeFace::posX)[0] + cube.texels(CubeFace::posY)[15] +
                                cube.texels(CubeFace::posZ)[3]) /
                               3.0f;
    EXPECT_LT(distance(cube.radiance({1, 1, 1}), expected), 1e-6f);
}

TEST(CubeMapRadiance, OfAConstantMapIsThatConstantEverywhere) {
    std::mt19937 random(kSeed);
    for (const int size : {1, 2, 16}) {
        CubeMap cube(size);
        for (const CubeFace face : kCubeFaces)
            for (glm::vec3& texel : cube.texels(face)) texel = glm::vec3(0.7f);
        for (int i = 0; i < 10000; ++i)
            EXPECT_NEAR(cube.radiance(randomDirection(random)).x, 0.7f, 3e-7f);
    }
}

TEST(CubeMapRadiance, IsContinuousOverEveryEdge) {
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<float> along(-1.0f, 1.0f);
    const int size = 8;
    const CubeMap cube = randomCube(size);
    const float step = 1e-4f;
    // Texels differ by up to 2 a component, so the slope is at most 2 * size / 2 a unit of s or t;
    // three channels, two sides.
    const float bound = 2.0f * step * static_cast<float>(size) * 2.0f * std::sqrt(3.0f);
    for (const CubeFace face : kCubeFaces)
        for (int i = 0; i < 1000; ++i) {
            const float t = along(random);
            for (const glm::vec2 edge :
                 {glm::vec2(1, t), glm::vec2(-1, t), glm::vec2(t, 1), glm::vec2(t, -1)}) {
                const glm::vec3 inside =
                    directionFromCube({face, edge.x * (1 - step), edge.y * (1 - step)});
                const glm::vec3 outside =
                    directionFromCube({face, edge.x * (1 + step), edge.y * (1 + step)});
                EXPECT_LT(distance(cube.radiance(inside), cube.radiance(outside)), bound);
            }
        }
}

TEST(CubeMapRadiance, StaysInBoundsForDirectionsThatAreNone) {
    const CubeMap cube = randomCube(4);
    const float nan = std::nanf("");
    (void)cube.radiance({0, 0, 0});
    (void)cube.radiance({nan, 1, 0});
    (void)cube.radiance({nan, nan, nan});
    (void)cube.radiance({INFINITY, INFINITY, 1});
}

double meanRadiance(const CubeMap& cube) {
    const std::vector<float> angles = faceSolidAngles(cube.faceSize());
    double sum = 0;
    for (const CubeFace face : kCubeFaces)
        for (std::size_t i = 0; i < angles.size(); ++i)
            sum += static_cast<double>(angles[i]) * static_cast<double>(cube.texels(face)[i].x);
    return sum / (4 * std::numbers::pi);
}

TEST(CubeMips, HalveDownToOneTexelAndKeepTheMean) {
    for (const int size : {16, 13}) {
        const CubeMap cube = randomCube(size);
        const std::vector<CubeMap> mips = cubeMips(cube);
        int expected = size;
        for (const CubeMap& mip : mips) {
            expected /= 2;
            EXPECT_EQ(mip.faceSize(), expected);
            // A cut texel counts by its part, as if its solid angle were spread evenly over it.
            EXPECT_NEAR(meanRadiance(mip), meanRadiance(cube), size == 16 ? 1e-6 : 2e-2);
        }
        EXPECT_EQ(expected, 1);
    }
    EXPECT_TRUE(cubeMips(CubeMap(1)).empty());
}

TEST(ShrunkCube, OfAConstantIsThatConstant) {
    CubeMap cube(12);
    for (const CubeFace face : kCubeFaces)
        for (glm::vec3& texel : cube.texels(face)) texel = glm::vec3(3.0f);
    for (const int size : {1, 5, 7, 12}) {
        const CubeMap shrunk = shrunkCube(cube, size);
        for (const CubeFace face : kCubeFaces)
            for (const glm::vec3& texel : shrunk.texels(face)) EXPECT_NEAR(texel.x, 3.0f, 1e-6f);
    }
}

}  // namespace
}  // namespace tukor
