#include "tukor/environment/spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tukor/base/parallel.h"
#include "tukor/environment/cube_texel.h"
#include "tukor/environment/equirect.h"
#include "tukor/environment/local_gather.h"
#include "tukor/environment/prefilter.h"
#include "tukor/environment/row_transform.h"

namespace tukor {
namespace {

constexpr unsigned kSeed = 20261122;

/// Noise with a sun of a few pixels, a thousand times brighter than the rest.
Image sunnyNoise(int width, int height) {
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<float> value(0.0f, 2.0f);
    Image image(width, height);
    for (glm::vec3& pixel : image.pixels()) pixel = {value(random), value(random), value(random)};
    for (int row = height / 4; row < height / 4 + 3; ++row)
        for (int column = width / 3; column < width / 3 + 3; ++column)
            image.at(column, row) = {3000.0f, 2500.0f, 2000.0f};
    return image;
}

/// The convolution by summing over all pixels, each split into parts: the definition itself.
glm::dvec3 exactConvolution(const Image& image, const Lobe& lobe, glm::dvec3 middle) {
    const int parts = lobe.alpha < 0.1 ? 12 : 5;
    const int height = parts * image.height(), width = parts * image.width();
    std::vector<double> sines, cosines;
    for (int column = 0; column < width; ++column) {
        const double longitude = 2 * std::numbers::pi * ((column + 0.5) / width - 0.5);
        sines.push_back(std::sin(longitude));
        cosines.push_back(std::cos(longitude));
    }
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    for (int row = 0; row < height; ++row) {
        const double theta = std::numbers::pi * (row + 0.5) / height;
        for (int column = 0; column < width; ++column) {
            const auto i = static_cast<std::size_t>(column);
            const double cosine = std::sin(theta) * (sines[i] * middle.x - cosines[i] * middle.z) +
                                  std::cos(theta) * middle.y;
            if (cosine <= 0.0) continue;
            const double weight = lobeWeight(lobe, cosine) * std::sin(theta);
            sum += weight * glm::dvec3(image.at(column / parts, row / parts));
            weights += weight;
        }
    }
    return sum / weights;
}

TEST(RowTransform, IsTheFourierSum) {
    const int size = 16;
    std::vector<Float8> real(size), imaginary(size);
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<float> value(-1.0f, 1.0f);
    for (int i = 0; i < size; ++i)
        for (int lane = 0; lane < 8; ++lane) {
            real[static_cast<std::size_t>(i)][lane] = value(random);
            imaginary[static_cast<std::size_t>(i)][lane] = value(random);
        }
    auto gotReal = real, gotImaginary = imaginary;
    const RowTransform transform(size);
    transform.forward(gotReal, gotImaginary);
    for (int k = 0; k < size; ++k) {
        double re = 0, im = 0;
        for (int i = 0; i < size; ++i) {
            const double angle = -2 * std::numbers::pi * i * k / size;
            const double a = real[static_cast<std::size_t>(i)][3],
                         b = imaginary[static_cast<std::size_t>(i)][3];
            re += a * std::cos(angle) - b * std::sin(angle);
            im += a * std::sin(angle) + b * std::cos(angle);
        }
        EXPECT_NEAR(gotReal[static_cast<std::size_t>(k)][3], re, 1e-5);
        EXPECT_NEAR(gotImaginary[static_cast<std::size_t>(k)][3], im, 1e-5);
    }
    transform.inverse(gotReal, gotImaginary);
    for (std::size_t i = 0; i < size; ++i) EXPECT_NEAR(gotReal[i][5] / size, real[i][5], 1e-6);
}

TEST(SpectrumOf, FindsASingleHarmonic) {
    // L = x y = sin^2(theta)... of degree 2, order 1; everything else is 0.
    Image image(256, 128);
    for (int row = 0; row < 128; ++row)
        for (int column = 0; column < 256; ++column) {
            const glm::vec3 d = directionFromEquirect({(static_cast<float>(column) + 0.5f) / 256,
                                                       (static_cast<float>(row) + 0.5f) / 128});
            image.at(column, row) = glm::vec3(5.0f + d.x * d.y);
        }
    const Spectrum spectrum = spectrumOf(image, 8);
    EXPECT_NEAR(spectrum.mean.x, 5.0, 1e-5);
    for (int m = 0; m <= 8; ++m)
        for (int l = m; l <= 8; ++l) {
            const auto& a = spectrum.at(l, m);
            const double power = std::hypot(a[0], a[1]);
            // |xy|^2 integrates to 4 pi / 15, half of it at m = -1; pixels of one value lose 1e-4.
            const double expected = l == 2 && m == 1 ? std::sqrt(2 * std::numbers::pi / 15) : 0.0;
            EXPECT_NEAR(power, expected, 3e-4) << l << ' ' << m;
        }
}

TEST(CubeFromSpectrum, GivesASmoothEnvironmentBack) {
    // Of degree 3: all of it survives.
    const auto radiance = [](glm::vec3 d) {
        return glm::vec3(1.0f + d.x, 2.0f + d.y * d.z, 3.0f + d.x * d.y * d.z);
    };
    Image image(512, 256);
    for (int row = 0; row < 256; ++row)
        for (int column = 0; column < 512; ++column)
            image.at(column, row) =
                radiance(directionFromEquirect({(static_cast<float>(column) + 0.5f) / 512,
                                                (static_cast<float>(row) + 0.5f) / 256}));
    const CubeMap cube = cubeFromSpectrum(spectrumOf(image, 16), std::vector<double>(17, 1.0), 16);
    for (const CubeFace face : kCubeFaces)
        for (int i = 0; i < 256; ++i) {
            const glm::vec3 d = glm::normalize(directionFromTexel({face, i % 16, i / 16}, 16));
            EXPECT_LT(glm::length(cube.texels(face)[static_cast<std::size_t>(i)] - radiance(d)),
                      3e-4f);
        }
}

TEST(Spectrum, IsTheSameForAnyNumberOfThreads) {
    const Image image = sunnyNoise(64, 32);
    setThreadCount(1);
    const Spectrum one = spectrumOf(image, 40);
    const std::vector<double> factorsOne = lobeFactors({LobeShape::ggx, 0.1}, 40);
    setThreadCount(0);
    const Spectrum all = spectrumOf(image, 40);
    EXPECT_EQ(factorsOne, lobeFactors({LobeShape::ggx, 0.1}, 40));
    for (int m = 0; m <= 40; ++m)
        for (int l = m; l <= 40; ++l) EXPECT_EQ(one.at(l, m), all.at(l, m));
}

TEST(LobeFactors, OfLambertAreThoseOfTheClampedCosine) {
    // 1, 2/3, 1/4, 0, -1/24, 0, 1/64 [Ramamoorthi & Hanrahan 2001]
    const double expected[] = {1.0, 2.0 / 3, 0.25, 0.0, -1.0 / 24, 0.0, 1.0 / 64};
    for (const Lobe& lobe : {Lobe{LobeShape::lambert, 1.0}, Lobe{LobeShape::ggx, 1.0}}) {
        const std::vector<double> factors = lobeFactors(lobe, 6);
        for (std::size_t l = 0; l < 7; ++l) EXPECT_NEAR(factors[l], expected[l], 1e-7) << l;
    }
}

TEST(LobeFactors, FallOffWithTheDegree) {
    const std::vector<double> factors = lobeFactors({LobeShape::ggx, 0.05}, 128);
    EXPECT_EQ(factors[0], 1.0);
    for (std::size_t l = 1; l < factors.size(); ++l) EXPECT_LT(factors[l], factors[l - 1]);
    EXPECT_LT(lobeFactors({LobeShape::ggx, 0.05}, lobeDegree({LobeShape::ggx, 0.05})).back(), 1e-4);
}

/// Every level against the definition, in a dozen directions.
void expectExact(const Image& image, const Lobe& lobe, const CubeMap& cube) {
    std::mt19937 random(kSeed);
    std::uniform_int_distribution<int> texel(0, cube.faceSize() - 1), face(0, 5);
    double error = 0, total = 0;
    for (int i = 0; i < 6; ++i) {
        const CubeTexel at{kCubeFaces[static_cast<std::size_t>(face(random))], texel(random),
                           texel(random)};
        const glm::dvec3 exact = exactConvolution(
            image, lobe, glm::normalize(glm::dvec3(directionFromTexel(at, cube.faceSize()))));
        const glm::dvec3 got(
            cube.texels(at.face)[static_cast<std::size_t>(at.row * cube.faceSize() + at.column)]);
        error += glm::dot(got - exact, got - exact);
        total += glm::dot(exact, exact);
        EXPECT_LT(glm::length(got - exact), 1e-2 * glm::length(exact)) << lobe.alpha;
    }
    EXPECT_LT(std::sqrt(error / total), 1e-3) << lobe.alpha;
}

TEST(PrefilteredChain, IsWithinAThousandthOfExactQuadrature) {
    const Image image = sunnyNoise(128, 64);
    const PrefilteredChain chain = prefilteredChain(image, {.faceSize = 64, .levels = 5});
    ASSERT_EQ(chain.levels.size(), 5u);
    for (std::size_t level = 1; level < 5; ++level) {
        EXPECT_EQ(chain.levels[level].faceSize(), 64 >> level);
        expectExact(image, {LobeShape::ggx, chain.alphas[level]}, chain.levels[level]);
    }
}

TEST(BlurredCube, OfSheenAndIrradianceIsExactToo) {
    const Image image = sunnyNoise(96, 48);  // no power of two
    expectExact(image, {LobeShape::lambert, 1.0},
                blurredCube(image, {LobeShape::lambert, 1.0}, 16).value());
    expectExact(image, {LobeShape::charlie, 0.3},
                blurredCube(image, {LobeShape::charlie, 0.3}, 16).value());
}

TEST(GatheredCube, FollowsExactQuadratureForSharpLobes) {
    // Sharper than the pixels: what is left of the lobe is its tail, and the look-up's own blur.
    Image image(256, 128);
    for (int row = 0; row < 128; ++row)
        for (int column = 0; column < 256; ++column)
            image.at(column, row) = glm::vec3(2.0f + std::sin(0.3f * static_cast<float>(column)) *
                                                         std::sin(0.2f * static_cast<float>(row)));
    const Lobe lobe{LobeShape::ggx, 0.003};
    const CubeMap cube = gatheredCube(image, lobe, 16);
    for (const CubeFace face : kCubeFaces) {
        const glm::dvec3 exact = exactConvolution(
            image, lobe, glm::normalize(glm::dvec3(directionFromTexel({face, 5, 9}, 16))));
        EXPECT_NEAR(cube.texels(face)[9 * 16 + 5].x, exact.x, 0.05 * exact.x);
    }
}

TEST(SpectrumOf, TakesPanoramasOfAnySize) {
    for (const glm::ivec2 size :
         {glm::ivec2(2, 1), glm::ivec2(6, 3), glm::ivec2(10, 5), glm::ivec2(1, 1)}) {
        Image image(size.x, size.y);
        for (glm::vec3& pixel : image.pixels()) pixel = glm::vec3(1.0f);
        image.at(0, 0) = glm::vec3(2.0f);
        const CubeMap cube = blurredCube(image, {LobeShape::lambert, 1.0}, 4).value();
        for (const glm::vec3& texel : cube.texels(CubeFace::posX)) {
            EXPECT_GE(texel.x, 1.0f - 1e-3f);
            EXPECT_LE(texel.x, 2.0f + 1e-3f);
        }
    }
}

TEST(PrefilteredChain, KeepsAConstantExactlyConstant) {
    Image image(64, 32);
    for (glm::vec3& pixel : image.pixels()) pixel = glm::vec3(0.7f, 1.0f, 123.0f);
    ChainOptions options{.faceSize = 16, .levels = 4};
    for (const LobeShape shape : {LobeShape::ggx, LobeShape::charlie}) {
        options.shape = shape;
        for (const CubeMap& level : prefilteredChain(image, options).levels)
            for (const CubeFace face : kCubeFaces)
                for (const glm::vec3& texel : level.texels(face))
                    ASSERT_EQ(texel, glm::vec3(0.7f, 1.0f, 123.0f)) << level.faceSize();
    }
}

TEST(PrefilteredChain, IsNeverNegativeBesideASun) {
    Image image(128, 64);
    image.at(40, 20) = glm::vec3(1e5f);
    for (const CubeMap& level : prefilteredChain(image, {.faceSize = 16, .levels = 4}).levels)
        for (const CubeFace face : kCubeFaces)
            for (const glm::vec3& texel : level.texels(face)) EXPECT_GE(texel.x, 0.0f);
}

TEST(PrefilteredChain, IsTheSameForAnyNumberOfThreads) {
    const Image image = sunnyNoise(128, 64);
    setThreadCount(1);
    const PrefilteredChain one = prefilteredChain(image, {.faceSize = 32, .levels = 5});
    setThreadCount(0);
    const PrefilteredChain all = prefilteredChain(image, {.faceSize = 32, .levels = 5});
    for (std::size_t level = 0; level < 5; ++level)
        for (const CubeFace face : kCubeFaces)
            EXPECT_TRUE(std::equal(one.levels[level].texels(face).begin(),
                                   one.levels[level].texels(face).end(),
                                   all.levels[level].texels(face).begin()));
}

TEST(PrefilteredChain, IsContinuousOverTheSeams) {
    // Texels across an edge differ by no more than their neighbours within the face do.
    const CubeMap level =
        prefilteredChain(sunnyNoise(128, 64), {.faceSize = 64, .levels = 4}).levels[2];
    const int size = level.faceSize();
    float across = 0.0f, within = 0.0f;
    for (const CubeFace face : kCubeFaces)
        for (int row = 0; row < size; ++row) {
            const auto at = [&](const CubeTexel& t) {
                return level.texels(t.face)[static_cast<std::size_t>(t.row * size + t.column)];
            };
            across = std::max(across, glm::length(at({face, 0, row}) -
                                                  at(texelAcrossEdge({face, -1, row}, size))));
            for (int column = 1; column < size; ++column)
                within = std::max(
                    within, glm::length(at({face, column, row}) - at({face, column - 1, row})));
        }
    EXPECT_LE(across, within);
}

TEST(PrefilteredChain, StopsWhenAsked) {
    const Image image = sunnyNoise(32, 16);
    EXPECT_TRUE(prefilteredChain(image, {}, [](float) { return false; }).levels.empty());
}

TEST(ChainAlphas, RunFromMirrorToRough) {
    const std::vector<double> filament = chainAlphas({.levels = 5});
    EXPECT_EQ(filament.front(), 0.0);
    EXPECT_NEAR(filament[1], 0.0179492, 1e-7);  // cmgen's level 1 of 5
    EXPECT_EQ(filament.back(), 1.0);
    const std::vector<double> linear = chainAlphas({.levels = 5, .scale = RoughnessScale::linear});
    EXPECT_NEAR(linear[2], 0.25, 1e-12);
    EXPECT_EQ(chainAlphas({.levels = 1}).front(), 0.0);
}

}  // namespace
}  // namespace tukor
