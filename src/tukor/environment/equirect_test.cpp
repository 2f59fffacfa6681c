#include "tukor/environment/equirect.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tukor/environment/cube_texel.h"
#include "tukor/environment/equirect_rows.h"

namespace tukor {
namespace {

constexpr unsigned kSeed = 20261122;

glm::vec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<float> normal;
    return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
}

/// Smooth but not symmetric in any axis.
glm::vec3 landscape(glm::vec3 d) {
    return {1.0f + 0.5f * d.x + 0.25f * d.y * d.z, 2.0f + d.y, 1.5f + std::sin(3.0f * d.z + d.x)};
}

Image panoramaOf(int width, int height) {
    Image image(width, height);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            image.at(column, row) = landscape(directionFromEquirect(
                {(static_cast<float>(column) + 0.5f) / static_cast<float>(width),
                 (static_cast<float>(row) + 0.5f) / static_cast<float>(height)}));
    return image;
}

Image noise(int width, int height) {
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<float> value(0.0f, 2.0f);
    Image image(width, height);
    for (glm::vec3& pixel : image.pixels()) pixel = {value(random), value(random), value(random)};
    return image;
}

TEST(EquirectFromDirection, PutsTheAxesWhereTheConventionSays) {
    const auto expectPlace = [](glm::vec3 direction, float x, float y) {
        const glm::vec2 place = equirectFromDirection(direction);
        EXPECT_NEAR(place.x, x, 1e-6f);
        EXPECT_NEAR(place.y, y, 1e-6f);
    };
    expectPlace({0, 0, -1}, 0.5f, 0.5f);
    expectPlace({2, 0, 0}, 0.75f, 0.5f);
    expectPlace({-1, 0, 0}, 0.25f, 0.5f);
    EXPECT_NEAR(equirectFromDirection({0, 1, 0}).y, 0.0f, 1e-6f);
    EXPECT_NEAR(equirectFromDirection({0, -1, 0}).y, 1.0f, 1e-6f);
    EXPECT_NEAR(std::abs(equirectFromDirection({0, 0, 1}).x - 0.5f), 0.5f, 1e-6f);
}

TEST(EquirectFromDirection, IsUndoneByDirectionFromEquirect) {
    std::mt19937 random(kSeed);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 direction = randomDirection(random);
        EXPECT_LT(glm::length(directionFromEquirect(equirectFromDirection(direction)) - direction),
                  2e-6f);
    }
}

TEST(EquirectRow, PlacesItsSamplesWhereTheirDirectionsSay) {
    const int samples = 37;
    EquirectRow places(1024, 512, samples);
    for (const CubeFace face : kCubeFaces)
        for (const float t : {-1.02f, -0.3f, 0.0f, 0.9f}) {
            places.place(face, t, -1.05f, 2.1f / (samples - 1));
            for (int i = 0; i < samples; ++i) {
                const float s = -1.05f + 2.1f / (samples - 1) * static_cast<float>(i);
                const glm::vec3 direction = directionFromCube({face, s, t});
                const glm::vec2 place = equirectFromDirection(direction);
                const auto at = static_cast<std::size_t>(i);
                EXPECT_NEAR(places.rows[at], 512 * place.y, 2e-4f);
                const float across = std::hypot(direction.x, direction.z);
                if (across < 1e-3f) continue;  // every longitude is right at the pole
                const float apart = std::abs(places.columns[at] - 1024 * place.x);
                EXPECT_NEAR(std::min(apart, 1024 - apart), 0.0f, 4e-4f)
                    << int(face) << ' ' << s << ' ' << t;
            }
        }
}

TEST(EquirectRadiance, IsThePixelAtItsCentreAndBilinearBetween) {
    const Image image = noise(16, 8);
    const auto at = [&](float column, float row) {
        return equirectRadiance(image, directionFromEquirect({column / 16, row / 8}));
    };
    EXPECT_NEAR(at(3.5f, 2.5f).x, image.at(3, 2).x, 2e-5f);
    EXPECT_NEAR(at(4.0f, 3.0f).x,
                0.25f * (image.at(3, 2).x + image.at(4, 2).x + image.at(3, 3).x + image.at(4, 3).x),
                2e-5f);
    // Over the seam behind, and over the pole to the far side.
    EXPECT_NEAR(at(16.0f, 2.5f).x, 0.5f * (image.at(15, 2).x + image.at(0, 2).x), 2e-5f);
    EXPECT_NEAR(at(3.5f, 0.25f).x, 0.75f * image.at(3, 0).x + 0.25f * image.at(11, 0).x, 2e-5f);
}

TEST(EquirectRadiance, StaysInBoundsForDirectionsThatAreNone) {
    const Image image = noise(4, 2);
    const float nan = std::nanf("");
    (void)equirectRadiance(image, {nan, nan, nan});
    (void)equirectRadiance(image, {0, 0, 0});
    (void)equirectRadiance(Image(2, 1), {1, 1, 1});
    (void)equirectRadiance(Image(1, 1), {1, 1, 1});
}

TEST(FaceSizeForEquirect, IsThePowerOfTwoAboveWidthOverPi) {
    EXPECT_EQ(faceSizeForEquirect(1024), 512);
    EXPECT_EQ(faceSizeForEquirect(804), 256);  // 255.9
    EXPECT_EQ(faceSizeForEquirect(805), 512);  // 256.2
    EXPECT_EQ(faceSizeForEquirect(4096), 2048);
    EXPECT_EQ(faceSizeForEquirect(2), 1);
}

TEST(CubeFromEquirect, KeepsAConstantAtEverySize) {
    Image image(64, 32);
    for (glm::vec3& pixel : image.pixels()) pixel = glm::vec3(0.3f, 1.0f, 700.0f);
    for (const int size : {1, 3, 8, 19, 20, 21, 64, 100}) {
        const CubeMap cube = cubeFromEquirect(image, size);
        for (const CubeFace face : kCubeFaces)
            for (const glm::vec3& texel : cube.texels(face)) {
                EXPECT_NEAR(texel.x, 0.3f, 1e-6f) << size;
                EXPECT_NEAR(texel.z, 700.0f, 1e-3f) << size;
            }
    }
}

TEST(CubeFromEquirect, ShowsThePanoramaWhereItWas) {
    // Linear interpolation errs by h^2 / 8 times the second derivative, here at most 10, in each of
    // two directions; a mean by h^2 / 24; both about twice that where the grid has a kink at a
    // seam.
    const auto bound = [](float step) { return 8.0f * step * step; };
    const Image image = panoramaOf(256, 128);
    std::mt19937 random(kSeed);
    for (const int size : {64, 128}) {
        const CubeMap cube = cubeFromEquirect(image, size);
        for (int i = 0; i < 2000; ++i) {
            const glm::vec3 direction = randomDirection(random);
            EXPECT_LT(
                glm::length(cube.radiance(direction) - landscape(direction)),
                bound(2.0f / static_cast<float>(size)) + bound(std::numbers::pi_v<float> / 128))
                << size;
        }
    }
}

/// Root mean square difference of the look-ups in a cube and in a panorama.
double lookUpError(const CubeMap& cube, const Image& image) {
    std::mt19937 random(kSeed);
    double sum = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 direction = randomDirection(random);
        const glm::vec3 delta = cube.radiance(direction) - equirectRadiance(image, direction);
        sum += static_cast<double>(glm::dot(delta, delta));
    }
    return std::sqrt(sum / 20000);
}

TEST(CubeFromEquirect, FitsLookUpsBetterThanTexelCentresWould) {
    const Image image = noise(128, 64);
    const CubeMap fitted = cubeFromEquirect(image, 64);
    CubeMap sampled(64);
    for (const CubeFace face : kCubeFaces)
        for (int i = 0; i < 64 * 64; ++i)
            sampled.texels(face)[static_cast<std::size_t>(i)] =
                equirectRadiance(image, directionFromTexel({face, i % 64, i / 64}, 64));
    EXPECT_LT(lookUpError(fitted, image), 0.9 * lookUpError(sampled, image));
}

TEST(CubeFromEquirect, TakesMeansOverAreasWhenItShrinks) {
    const Image image = noise(512, 256);
    const int size = 32;
    const CubeMap cube = cubeFromEquirect(image, size);
    double error = 0, total = 0;
    for (const CubeFace face : kCubeFaces)
        for (int texel = 0; texel < size * size; texel += 41) {
            constexpr int kSamples = 64;
            glm::dvec3 sum(0.0);
            double weights = 0;
            for (int i = 0; i < kSamples * kSamples; ++i) {
                const float s = (static_cast<float>(texel % size) +
                                 (static_cast<float>(i % kSamples) + 0.5f) / kSamples) *
                                    2 / size -
                                1;
                const float t = (static_cast<float>(texel / size) +
                                 (static_cast<float>(i / kSamples) + 0.5f) / kSamples) *
                                    2 / size -
                                1;
                const glm::vec2 place = equirectFromDirection(directionFromCube({face, s, t}));
                const double weight = std::pow(1.0 + static_cast<double>(s * s + t * t), -1.5);
                sum +=
                    weight * glm::dvec3(image.at(std::min(static_cast<int>(place.x * 512), 511),
                                                 std::min(static_cast<int>(place.y * 256), 255)));
                weights += weight;
            }
            sum /= weights;
            const glm::dvec3 delta =
                sum - glm::dvec3(cube.texels(face)[static_cast<std::size_t>(texel)]);
            error += glm::dot(delta, delta);
            total += glm::dot(sum, sum);
        }
    // White noise is the worst there is; pictures are ten times smoother.
    EXPECT_LT(std::sqrt(error / total), 1e-2);
}

/// The mean of the pixels, as areas of one value, over a texel's solid angle.
glm::dvec3 exactMean(const Image& image, CubeTexel texel, int faceSize) {
    constexpr int kPoints = 80;
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    for (int i = 0; i < kPoints * kPoints; ++i) {
        const double s = 2 * (texel.column + (i % kPoints + 0.5) / kPoints) / faceSize - 1;
        const double t = 2 * (texel.row + (i / kPoints + 0.5) / kPoints) / faceSize - 1;
        const glm::vec2 place = equirectFromDirection(
            directionFromCube({texel.face, static_cast<float>(s), static_cast<float>(t)}));
        const double weight = std::pow(1 + s * s + t * t, -1.5);
        sum += weight * glm::dvec3(image.at(
                            std::min(int(place.x * float(image.width())), image.width() - 1),
                            std::min(int(place.y * float(image.height())), image.height() - 1)));
        weights += weight;
    }
    return sum / weights;
}

TEST(CubeFromEquirect, IsTheExactMeanOfNoiseWhereItShrinks) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> even(0.5f, 1.5f);
    // Sizes odd and even, widths that four quarters cut alike or not.
    for (const auto& [width, faceSize] : {std::pair(64, 8), std::pair(64, 9), std::pair(50, 8),
                                          std::pair(26, 5), std::pair(8, 1)}) {
        Image image(width, width / 2);
        for (glm::vec3& pixel : image.pixels()) pixel = {even(random), even(random), even(random)};
        const CubeMap cube = cubeFromEquirect(image, faceSize);
        double error = 0.0;
        for (const CubeFace face : kCubeFaces)
            for (int row = 0; row < faceSize; ++row)
                for (int column = 0; column < faceSize; ++column) {
                    const glm::dvec3 difference =
                        glm::dvec3(
                            cube.texels(face)[static_cast<std::size_t>(row * faceSize + column)]) -
                        exactMean(image, {face, column, row}, faceSize);
                    error += glm::dot(difference, difference) / (18.0 * faceSize * faceSize);
                }
        // Of a mean of 1: pixel edges run aslant of the pieces that they are cut into.
        EXPECT_LT(std::sqrt(error), 3e-3) << width << " to " << faceSize;
    }
}

}  // namespace
}  // namespace tukor
