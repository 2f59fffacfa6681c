#include "tukor/optics/absorption.h"

#include <cmath>

#include <gtest/gtest.h>

namespace tukor::optics {
namespace {

TEST(Transmittance, IsOneWithoutAbsorptionOrDistance) {
    EXPECT_EQ(transmittance(vec3(0.0f), 3.0f), vec3(1.0f));
    EXPECT_EQ(transmittance(vec3(0.0f), 1e30f), vec3(1.0f));
    EXPECT_EQ(transmittance(vec3(0.1f, 2.0f, 30.0f), 0.0f), vec3(1.0f));
}

TEST(Transmittance, IsTheExponentialOfOpticalDepth) {
    const vec3 T = transmittance(vec3(0.1f, 2.0f, 30.0f), 0.5f);
    EXPECT_NEAR(T.x, std::exp(-0.05), 1e-7);
    EXPECT_NEAR(T.y, std::exp(-1.0), 1e-7);
    EXPECT_NEAR(T.z, std::exp(-15.0), 1e-12);
}

TEST(Transmittance, MultipliesAlongAPath) {
    const vec3 sigmaA(0.3f, 1.0f, 4.0f);
    const vec3 whole = transmittance(sigmaA, 1.25f);
    const vec3 parts = transmittance(sigmaA, 0.5f) * transmittance(sigmaA, 0.75f);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(parts[channel], whole[channel], 1e-6f * whole[channel]);
    }
}

TEST(Transmittance, VanishesInsteadOfOverflowing) {
    EXPECT_EQ(transmittance(vec3(1e20f), 1e15f), vec3(0.0f));
}

}  // namespace
}  // namespace tukor::optics
