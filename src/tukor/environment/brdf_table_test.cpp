#include "tukor/environment/brdf_table.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace tukor {
namespace {

/// Height-correlated Smith shadowing over 4 cosIn cosOut. [Heitz 2014]
double visibility(double cosIn, double cosOut, double a2) {
    return 0.5 / (cosOut * std::sqrt(cosIn * cosIn * (1 - a2) + a2) +
                  cosIn * std::sqrt(cosOut * cosOut * (1 - a2) + a2));
}

constexpr int kSteps = 700;

/// Over facets, by midpoints in their azimuth and in psi, tan(theta) = alpha tan(psi), by which
/// GGX times cosHalf is sin(2 psi) dpsi dphi / (2 pi). Views from the side want more steps: the
/// horizon cuts the lobe in its middle.
glm::dvec2 byFacets(double cosOut, double roughness, int steps) {
    const double alpha = roughness * roughness, sinOut = std::sqrt(1 - cosOut * cosOut);
    glm::dvec2 sum(0.0);
    for (int i = 0; i < steps; ++i) {
        const double psi = 0.5 * std::numbers::pi * (i + 0.5) / steps;
        const double cosHalf = 1 / std::sqrt(1 + std::pow(alpha * std::tan(psi), 2));
        const double sinHalf = std::sqrt(1 - cosHalf * cosHalf);
        for (int j = 0; j < steps; ++j) {
            const double phi = std::numbers::pi * (j + 0.5) / steps;
            const double outHalf = sinOut * sinHalf * std::cos(phi) + cosOut * cosHalf;
            const double cosIn = 2 * outHalf * cosHalf - cosOut;
            if (outHalf <= 0 || cosIn <= 0) continue;
            const double fresnel = std::pow(1 - outHalf, 5);
            sum += std::sin(2 * psi) / cosHalf * 4 * outHalf * cosIn *
                   visibility(cosIn, cosOut, alpha * alpha) * glm::dvec2(1 - fresnel, fresnel);
        }
    }
    return sum * (0.5 * std::numbers::pi / (steps * steps));
}

/// Over incoming directions, by midpoints in the cube root of the cosine and in the azimuth.
double sheenByDirections(double cosOut, double alpha) {
    const double sinOut = std::sqrt(1 - cosOut * cosOut);
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double root = (i + 0.5) / kSteps, cosIn = root * root * root;
        const double sinIn = std::sqrt(1 - cosIn * cosIn);
        for (int j = 0; j < kSteps; ++j) {
            const double phi = std::numbers::pi * (j + 0.5) / kSteps;
            const double cosBoth = sinOut * sinIn * std::cos(phi) + cosOut * cosIn;
            const double cosHalf2 = std::pow(cosOut + cosIn, 2) / (2 + 2 * cosBoth);
            sum += std::pow(std::max(1 - cosHalf2, 0.0), 0.5 / alpha) * cosIn * root * root /
                   (cosOut + cosIn - cosOut * cosIn);
        }
    }
    return sum * (2 + 1 / alpha) * 0.75 / (kSteps * kSteps);
}

TEST(BrdfTable, MeetsTheLimitsOfAMirrorAndLosesEnergyWithRoughness) {
    const Image table = brdfTable(32);
    for (int column = 0; column < 32; ++column) {
        // A mirror: Schlick's Fresnel itself. The first row has alpha = 2.4e-4.
        const double fresnel = std::pow(1 - (column + 0.5) / 32, 5);
        EXPECT_NEAR(table.at(column, 0).y, fresnel, 2e-3) << column;
        EXPECT_NEAR(table.at(column, 0).x, 1 - fresnel, 2e-3) << column;
        for (int row = 0; row < 32; ++row) {
            const float whole = table.at(column, row).x + table.at(column, row).y;
            EXPECT_LE(whole, 1.0f + 1e-5f);
            EXPECT_GT(whole, 0.3f);
        }
        EXPECT_LT(table.at(column, 31).x + table.at(column, 31).y,
                  table.at(column, 0).x + table.at(column, 0).y);
    }
}

TEST(BrdfTable, EqualsBruteForceAllOver) {
    constexpr int kSize = 32;
    const Image table = brdfTable(kSize);
    for (const int row : {0, 3, 6, 9, 12, 20, 31})
        for (const int column : {0, 1, 4, 15, 30}) {
            const double cosOut = (column + 0.5) / kSize, roughness = (row + 0.5) / kSize;
            const glm::dvec2 expected = byFacets(cosOut, roughness, column < 2 ? 2500 : 700);
            EXPECT_NEAR(table.at(column, row).x, expected.x, 1e-4) << column << " " << row;
            EXPECT_NEAR(table.at(column, row).y, expected.y, 1e-4) << column << " " << row;
            const double alpha = std::max(roughness * roughness, 1e-3);
            EXPECT_NEAR(table.at(column, row).z, sheenByDirections(cosOut, alpha), 1e-4)
                << column << " " << row;
        }
    // By 300 x 300 points.
    EXPECT_NEAR(table.at(30, 9).x, 0.990537, 2e-6);
    EXPECT_NEAR(table.at(30, 9).y, 2.703e-5, 2e-8);
}

TEST(BrdfTable, EndsAreMirrorsAndTheWorkCanBeStopped) {
    const Image nodes = brdfNodeTable(48);
    EXPECT_NEAR(nodes.at(47, 0).x, 1.0f, 1e-5f);
    EXPECT_NEAR(nodes.at(47, 0).y, 0.0f, 1e-5f);
    EXPECT_TRUE(brdfTable(8, [](float) { return false; }).empty());
}

TEST(BrdfTable, EqualsTheHemisphericalIntegral) {
    // The same integral over incoming directions, by brute force.
    const double cosOut = (20 + 0.5) / 32, roughness = (16 + 0.5) / 32, a2 = std::pow(roughness, 4);
    const double sinOut = std::sqrt(1 - cosOut * cosOut);
    glm::dvec2 sum(0.0);
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const double cosIn = (i + 0.5) / kSteps, sinIn = std::sqrt(1 - cosIn * cosIn);
            const double phi = std::numbers::pi * (j + 0.5) / kSteps;
            const double cosHalf2 = std::pow(cosIn + cosOut, 2) /
                                    (2 + 2 * (cosIn * cosOut + sinIn * sinOut * std::cos(phi)));
            const double outHalf =
                std::sqrt(0.5 * (1 + cosIn * cosOut + sinIn * sinOut * std::cos(phi)));
            const double f = cosHalf2 * (a2 - 1) + 1;
            const double d = a2 / (std::numbers::pi * f * f);
            const double v = visibility(cosIn, cosOut, a2);
            const double weight = d * v * cosIn * 2 * std::numbers::pi / (kSteps * kSteps);
            const double fresnel = std::pow(1 - outHalf, 5);
            sum += weight * glm::dvec2(1 - fresnel, fresnel);
        }
    const Image table = brdfTable(32);
    EXPECT_NEAR(table.at(20, 16).x, sum.x, 1e-4);
    EXPECT_NEAR(table.at(20, 16).y, sum.y, 1e-4);
}

}  // namespace
}  // namespace tukor
