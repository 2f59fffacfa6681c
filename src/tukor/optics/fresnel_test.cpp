#include "tukor/optics/fresnel.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include <gtest/gtest.h>

namespace tukor::optics {
namespace {

// The lecture's figures.
const vec3 kGoldEta(0.21f, 0.485f, 1.29f), kGoldK(3.13f, 2.23f, 1.76f);
const vec3 kSilverEta(0.15f, 0.14f, 0.13f), kSilverK(3.7f, 3.11f, 2.47f);
/// Unpolarised reflectance of index eta + i k straight from the complex amplitudes.
double complexFresnel(double cosThetaI, double eta, double k) {
    const std::complex<double> index(eta, k);
    const double sin2 = 1.0 - cosThetaI * cosThetaI;
    const std::complex<double> g = std::sqrt(index * index - sin2);  // index * cosThetaT
    const std::complex<double> rs = (cosThetaI - g) / (cosThetaI + g);
    const std::complex<double> rp =
        (index * index * cosThetaI - g) / (index * index * cosThetaI + g);
    return 0.5 * (std::norm(rs) + std::norm(rp));
}

double criticalCosine(double eta) {
    return eta < 1.0 ? std::sqrt(1.0 - eta * eta) : -1.0;
}

/// Float rounding, but the slope is infinite at the critical angle: there sqrt(ulp) is what is
/// left.
double tolerance(double cosThetaI, double eta) {
    return std::abs(cosThetaI - criticalCosine(eta)) < 1e-3 ? 1e-3 : 3e-6;
}

TEST(FresnelDielectric, IsOneBeyondTheCriticalAngle) {
    for (const float eta : {1.0f / 2.42f, 1.0f / 1.5f, 1.0f / 1.333f, 0.99f}) {
        const float critical = static_cast<float>(criticalCosine(eta));
        for (int i = 0; i <= 1000; ++i) {
            const float cosThetaI = 0.9999f * critical * static_cast<float>(i) / 1000.0f;
            EXPECT_EQ(fresnelDielectric(cosThetaI, eta), 1.0f) << eta << ' ' << cosThetaI;
        }
        EXPECT_LT(fresnelDielectric(1.01f * critical, eta), 1.0f) << eta;
    }
}

TEST(FresnelDielectric, EqualsTheComplexAmplitudesInDouble) {
    for (const float eta : {1.0003f, 1.01f, 1.333f, 1.46f, 2.42f, 4.0f}) {
        for (const float index : {eta, 1.0f / eta}) {
            for (int i = 1; i <= 4096; ++i) {
                const float cosThetaI = static_cast<float>(i) / 4096.0f;
                EXPECT_NEAR(fresnelDielectric(cosThetaI, index),
                            complexFresnel(cosThetaI, index, 0.0), tolerance(cosThetaI, index))
                    << "eta " << index << " cosThetaI " << cosThetaI;
            }
        }
    }
}

TEST(FresnelDielectric, ConservesEnergyWithTheTransmittedAmplitudes) {
    // T = (etaT cosThetaT / etaI cosThetaI) |t|^2 from ts = 2 c / (c + g), tp = 2 eta c / (eta^2 c
    // + g): the half of the balance that fresnelDielectric does not compute.
    for (const double eta : {1.333, 1.46, 2.42, 1.0 / 1.333, 1.0 / 1.46}) {
        for (int i = 1; i <= 1000; ++i) {
            const double c = i / 1000.0;
            const double g2 = eta * eta - 1.0 + c * c;
            if (g2 <= 1e-3) continue;
            const double g = std::sqrt(g2);
            const double ts = 2.0 * c / (c + g);
            const double tp = 2.0 * eta * c / (eta * eta * c + g);
            const double T = 0.5 * (g / c) * (ts * ts + tp * tp);
            EXPECT_NEAR(fresnelDielectric(static_cast<float>(c), static_cast<float>(eta)) + T, 1.0,
                        1e-5)
                << "eta " << eta << " cosThetaI " << c;
        }
    }
}

TEST(FresnelDielectric, IsTheSquaredIndexRatioAtNormalIncidence) {
    for (const float eta : {1.333f, 1.46f, 2.42f}) {
        const float r = (eta - 1.0f) / (eta + 1.0f);
        EXPECT_NEAR(fresnelDielectric(1.0f, eta), r * r, 1e-7f) << eta;
        EXPECT_NEAR(fresnelDielectric(1.0f, 1.0f / eta), r * r, 1e-7f) << eta;
        EXPECT_NEAR(reflectanceAtNormal(vec3(eta), vec3(0.0f)).x, r * r, 1e-7f) << eta;
    }
}

TEST(FresnelDielectric, LosesThePPolarisationAtBrewstersAngle) {
    // tan thetaI = eta makes Rp = 0, so the unpolarised reflectance is Rs / 2, and Rs = ((1 -
    // eta^2) / (1 + eta^2))^2.
    for (const float eta : {1.333f, 1.46f, 2.42f, 1.0f / 1.333f}) {
        const float cosBrewster = 1.0f / std::sqrt(1.0f + eta * eta);
        const float rs = (1.0f - eta * eta) / (1.0f + eta * eta);
        EXPECT_NEAR(fresnelDielectric(cosBrewster, eta), 0.5f * rs * rs, 1e-6f) << eta;
    }
}

TEST(FresnelDielectric, IsZeroWhereTheIndexDoesNotChange) {
    for (int i = 1; i <= 1000; ++i) {
        EXPECT_EQ(fresnelDielectric(static_cast<float>(i) / 1000.0f, 1.0f), 0.0f) << i;
    }
}

TEST(FresnelDielectric, IsTheSameFromBothSides) {
    // Stokes: R(thetaI, eta) = R(thetaT, 1 / eta).
    for (const double eta : {1.01, 1.333, 1.46, 2.42}) {
        for (int i = 1; i <= 1000; ++i) {
            const double cosThetaI = i / 1000.0;
            const double cosThetaT = std::sqrt(1.0 - (1.0 - cosThetaI * cosThetaI) / (eta * eta));
            // The inputs are rounded (6e-8), which moves g = cosThetaI by that over itself; R's
            // slope in it is at most 4.
            const double below = tolerance(cosThetaT, 1.0 / eta) + 4.0 * 1.2e-7 / cosThetaI;
            EXPECT_NEAR(
                fresnelDielectric(static_cast<float>(cosThetaI), static_cast<float>(eta)),
                fresnelDielectric(static_cast<float>(cosThetaT), static_cast<float>(1.0 / eta)),
                below)
                << "eta " << eta << " cosThetaI " << cosThetaI;
        }
    }
}

TEST(FresnelConductor, EqualsTheComplexAmplitudesInDouble) {
    double worst = 0.0;
    for (const float eta : {0.05f, 0.2f, 0.7f, 0.999f, 1.0f, 1.46f, 3.0f, 8.0f}) {
        for (const float k : {0.0f, 1e-6f, 1e-4f, 1e-3f, 0.01f, 0.1f, 1.0f, 3.0f, 8.0f}) {
            for (int i = 0; i <= 2048; ++i) {
                const float cosThetaI = static_cast<float>(i) / 2048.0f;
                if (eta == 1.0f && k == 0.0f && i == 0) continue;  // 0 / 0: nothing to compare
                const double error = std::abs(fresnelConductor(cosThetaI, vec3(eta), vec3(k)).x -
                                              complexFresnel(cosThetaI, eta, k));
                EXPECT_LE(error, k < 0.05f ? tolerance(cosThetaI, eta) : 3e-6)
                    << "eta " << eta << " k " << k << " cosThetaI " << cosThetaI;
                if (tolerance(cosThetaI, eta) < 1e-5) worst = std::max(worst, error);
            }
        }
    }
    RecordProperty("worst", std::to_string(worst));
}

TEST(FresnelConductor, IsTheDielectricWithoutExtinction) {
    for (const float eta : {1.0f / 2.42f, 1.0f / 1.46f, 0.9f, 1.0f, 1.333f, 2.42f}) {
        for (int i = 0; i <= 2048; ++i) {
            const float cosThetaI = static_cast<float>(i) / 2048.0f;
            EXPECT_NEAR(fresnelConductor(cosThetaI, vec3(eta), vec3(0.0f)).y,
                        fresnelDielectric(cosThetaI, eta), tolerance(cosThetaI, eta))
                << "eta " << eta << " cosThetaI " << cosThetaI;
        }
    }
}

TEST(FresnelConductor, IsR0AtNormalIncidenceAndOneAlongTheSurface) {
    const vec3 R0 = reflectanceAtNormal(kGoldEta, kGoldK);
    const vec3 normal = fresnelConductor(1.0f, kGoldEta, kGoldK);
    const vec3 grazing = fresnelConductor(0.0f, kGoldEta, kGoldK);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(normal[channel], R0[channel], 1e-6f);
        EXPECT_NEAR(grazing[channel], 1.0f, 1e-6f);
    }
    // ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2) of the lecture's gold, by hand.
    EXPECT_NEAR(R0.x, 0.92541f, 1e-5f);
    EXPECT_NEAR(R0.y, 0.72974f, 1e-5f);
    EXPECT_NEAR(R0.z, 0.38142f, 1e-5f);
}

TEST(FresnelConductor, GrowsBeyondDoubtTowardsGrazing) {
    // Continuity at the end: from 1e-3 to 0 the slope of R is about -4 Re(1 / (eta + i k)), at
    // most 4.
    for (int i = 0; i <= 1000; ++i) {
        const float cosThetaI = static_cast<float>(i) * 1e-6f;
        const vec3 R = fresnelConductor(cosThetaI, kSilverEta, kSilverK);
        EXPECT_GE(R.x, 1.0f - 4.0f * cosThetaI - 1e-6f) << cosThetaI;
    }
}

float largestSchlickError(vec3 eta, vec3 k) {
    float worst = 0.0f;
    const vec3 R0 = reflectanceAtNormal(eta, k);
    for (int i = 0; i <= 10000; ++i) {
        const float cosThetaI = static_cast<float>(i) / 10000.0f;
        const vec3 error = abs(fresnelSchlick(cosThetaI, R0) - fresnelConductor(cosThetaI, eta, k));
        worst = std::max({worst, error.x, error.y, error.z});
    }
    return worst;
}

TEST(FresnelSchlick, IsExactAtBothEnds) {
    const vec3 R0(0.2f, 0.5f, 0.9f);
    EXPECT_EQ(fresnelSchlick(1.0f, R0), R0);
    EXPECT_EQ(fresnelSchlick(0.0f, R0), vec3(1.0f));
}

TEST(FresnelSchlick, ErrsByNoMoreThanMeasured) {
    EXPECT_NEAR(largestSchlickError(kSilverEta, kSilverK), 0.0163f, 1e-4f);
    EXPECT_NEAR(largestSchlickError(kGoldEta, kGoldK), 0.0256f, 1e-4f);
    // The figures that the literature quotes belong to other measurements of the same metals.
    struct Set {
        const char* metal;
        vec3 eta, k;
        float error;
    };
    const Set sets[] = {
        {"silver", {0.155f, 0.117f, 0.138f}, {4.828f, 3.122f, 2.147f}, 0.019f},
        {"gold", {0.143f, 0.375f, 1.442f}, {3.983f, 2.386f, 1.603f}, 0.029f},
        {"copper", {0.200f, 0.924f, 1.102f}, {3.912f, 2.452f, 2.142f}, 0.026f},
        {"aluminium", {1.657f, 0.880f, 0.521f}, {9.224f, 6.270f, 4.837f}, 0.126f},
        {"chromium", {3.107f, 3.181f, 2.323f}, {3.331f, 3.329f, 3.135f}, 0.198f},
    };
    for (const Set& set : sets) {
        EXPECT_NEAR(largestSchlickError(set.eta, set.k), set.error, 6e-4f) << set.metal;
    }
}

TEST(Fresnel, StaysFiniteAndBetweenZeroAndOne) {
    int checked = 0;
    for (int i = 0; i <= 400; ++i) {
        // Uniform, and crowded towards grazing down to denormal cosines.
        const float x = static_cast<float>(i) / 400.0f;
        for (const float cosThetaI : {x, std::pow(x, 12.0f), x == 0.0f ? 0.0f : 1e-42f}) {
            for (int j = 0; j <= 100; ++j) {
                const float eta = std::pow(10.0f, -3.0f + 6.0f * static_cast<float>(j) / 100.0f);
                const float dielectric = fresnelDielectric(cosThetaI, eta);
                ASSERT_TRUE(dielectric >= 0.0f && dielectric <= 1.0f)
                    << cosThetaI << ' ' << eta << ' ' << dielectric;
                for (const float k : {0.0f, 1e-12f, 1e-4f, 0.3f, 3.0f, 1000.0f}) {
                    const float R = fresnelConductor(cosThetaI, vec3(eta), vec3(k)).z;
                    ASSERT_TRUE(R >= 0.0f && R <= 1.0f)
                        << cosThetaI << ' ' << eta << ' ' << k << ' ' << R;
                    ++checked;
                }
            }
            for (const float R0 : {0.0f, 0.02f, 0.3f, 0.77f, 1.0f}) {
                const float R = fresnelSchlick(cosThetaI, vec3(R0)).x;
                ASSERT_TRUE(R >= R0 - 1e-7f && R <= 1.0f) << cosThetaI << ' ' << R0 << ' ' << R;
            }
        }
    }
    EXPECT_GT(checked, 700000);
}

}  // namespace
}  // namespace tukor::optics
