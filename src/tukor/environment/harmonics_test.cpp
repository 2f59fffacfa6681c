#include "tukor/environment/harmonics.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/environment/equirect.h"

namespace tukor {
namespace {

template <class Radiance>
Image panoramaOf(const Radiance& radiance) {
    Image image(256, 128);
    for (int row = 0; row < 128; ++row)
        for (int column = 0; column < 256; ++column)
            image.at(column, row) =
                radiance(directionFromEquirect({(static_cast<float>(column) + 0.5f) / 256,
                                                (static_cast<float>(row) + 0.5f) / 128}));
    return image;
}

/// Of degree 2, different in every axis.
glm::vec3 landscape(glm::vec3 d) {
    return {1.0f + d.x, 2.0f + d.y + 0.5f * d.x * d.z, 3.0f + d.z + 0.3f * d.y * d.y};
}

TEST(HarmonicBasis, IsTheListOfPolynomials) {
    const glm::dvec3 d = glm::normalize(glm::dvec3(0.3, -0.5, 0.7));
    const std::vector<double> basis = harmonicBasis(3, d);
    const double expected[] = {0.282095,
                               0.488603 * d.y,
                               0.488603 * d.z,
                               0.488603 * d.x,
                               1.092548 * d.x * d.y,
                               1.092548 * d.y * d.z,
                               0.315392 * (3 * d.z * d.z - 1),
                               1.092548 * d.x * d.z,
                               0.546274 * (d.x * d.x - d.y * d.y)};
    for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(basis[i], expected[i], 1e-6) << i;
}

TEST(HarmonicsOf, GiveTheRadianceBackInWorldAxes) {
    const Spectrum spectrum = spectrumOf(panoramaOf(landscape), 12);
    for (const int bands : {3, 7}) {
        const Harmonics harmonics = harmonicsOf(spectrum, bands);
        for (const glm::vec3 d :
             {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1),
              glm::normalize(glm::vec3(1, -2, 3)), glm::normalize(glm::vec3(-3, 1, -1))})
            // Pixels are areas of one value: (pi / 128)^2 / 24 of the second derivatives is lost,
            // which are up to 6 in two directions and three channels.
            EXPECT_LT(glm::length(valueOf(harmonics, d) - glm::dvec3(landscape(d))), 6e-4) << bands;
    }
}

TEST(IrradianceOf, AConstantIsPiTimesIt) {
    const Spectrum spectrum = spectrumOf(panoramaOf([](glm::vec3) { return glm::vec3(0.5f); }), 8);
    const Harmonics irradiance = irradianceOf(harmonicsOf(spectrum, 4));
    EXPECT_NEAR(valueOf(irradiance, {0, 0, 1}).x, 0.5 * std::numbers::pi, 1e-6);
    EXPECT_NEAR(valueOf(irradiance, {1, 0, 0}).x, 0.5 * std::numbers::pi, 1e-6);
}

TEST(Windowed, FadesBandsAndKeepsTheMean) {
    Harmonics harmonics{3, std::vector<glm::dvec3>(9, glm::dvec3(1.0))};
    for (const HarmonicWindow window : {HarmonicWindow::hann, HarmonicWindow::lanczos}) {
        const Harmonics faded = windowed(harmonics, window);
        EXPECT_EQ(faded.coefficients[0].x, 1.0);
        EXPECT_LT(faded.coefficients[1].x, 1.0);
        EXPECT_LT(faded.coefficients[4].x, faded.coefficients[1].x);
        EXPECT_GT(faded.coefficients[4].x, 0.0);
    }
    EXPECT_EQ(windowed(harmonics, HarmonicWindow::none).coefficients[8].x, 1.0);
}

TEST(HarmonicsText, ListsEveryCoefficient) {
    const Harmonics harmonics{2, {{1, 2, 3}, {0.5, 0, 0}, {0, 0.25, 0}, {0, 0, -1}}};
    EXPECT_EQ(jsonOf(harmonics, "radiance"),
              "{\n  \"quantity\": \"radiance\",\n"
              "  \"basis\": \"real, orthonormal, no Condon-Shortley sign, y up\",\n"
              "  \"bands\": 2,\n  \"coefficients\": [\n    [1, 2, 3],\n    [0.5, 0, 0],\n    [0, "
              "0.25, 0],\n"
              "    [0, 0, -1]\n  ]\n}\n");
    const std::string header = cHeaderOf(harmonics, "irradiance", "light");
    EXPECT_THAT(header, testing::HasSubstr("static const float light[4][3] = {"));
    EXPECT_THAT(header, testing::HasSubstr("{0.00000000f, 0.00000000f, -1.00000000f},  // L1,1"));
}

}  // namespace
}  // namespace tukor
