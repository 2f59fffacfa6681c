#include "tukor/optics/dispersion.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tukor/optics/spectrum.h"

namespace tukor::optics {
namespace {

TEST(Dispersion, GivesAbbesNumberBack) {
    for (const float abbe : {20.0f, 33.54f, 64.17f}) {
        const float etaF = indexAt(1.5168f, 20.0f / abbe, 486.13f);
        const float etaC = indexAt(1.5168f, 20.0f / abbe, 656.27f);
        EXPECT_NEAR(0.5168f / (etaF - etaC), abbe, 1e-3f * abbe);  // lines to four digits
        EXPECT_NEAR(indexAt(1.5168f, 20.0f / abbe, 587.56f), 1.5168f, 1e-5f);
    }
    EXPECT_EQ(indexAt(1.5f, 0.0f, 400.0f), 1.5f);
}

// N-BK7's Sellmeier formula [Schott 2023] at the ends of the visible: two terms of Cauchy's are not
// all of it.
TEST(Dispersion, IsNearMeasuredGlass) {
    EXPECT_NEAR(indexAt(1.5168f, 20.0f / 64.17f, 435.8f), 1.52668f, 5e-4f);
    EXPECT_NEAR(indexAt(1.5168f, 20.0f / 64.17f, 706.5f), 1.51289f, 5e-4f);
}

TEST(Spectrum, WeightsAverageToWhite) {
    const Spectrum spectrum = visibleSpectrum();
    glm::dvec3 sum(0.0);
    constexpr int kCount = 10000;
    float last = 0.0f;
    for (int i = 0; i < kCount; ++i) {
        const Wavelength w = wavelengthAt(spectrum, (static_cast<float>(i) + 0.5f) / kCount);
        EXPECT_GE(w.nm, last);
        EXPECT_LE(std::max({w.weight.x, w.weight.y, w.weight.z}), 3.1f);
        last = w.nm;
        sum += glm::dvec3(w.weight);
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] / kCount, 1.0, 1e-3);
    EXPECT_GT(wavelengthAt(spectrum, 0.95f).weight.x, 2.0f);  // red is long
    EXPECT_GT(wavelengthAt(spectrum, 0.05f).weight.z, 2.0f);
}

}  // namespace
}  // namespace tukor::optics
