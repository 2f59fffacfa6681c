#include "tukor/image/display.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tukor/image/tonemap.h"

namespace tukor {
namespace {

using glm::vec3;

double srgb(double c) {
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

TEST(Srgb8, EqualsTheRoundedTransferFunction) {
    for (float v = 1e-5f; v < 1.1f; v *= 1.0001f) {
        const double exact = 255.0 * srgb(std::min(double(v), 1.0));
        if (std::abs(exact - std::floor(exact) - 0.5) < 1e-4) continue;  // a tie, up to rounding
        ASSERT_EQ(srgb8(v), static_cast<int>(std::lround(exact))) << v;
    }
    EXPECT_EQ(srgb8(0.0f), 0);
    EXPECT_EQ(srgb8(-1.0f), 0);
    EXPECT_EQ(srgb8(std::nanf("")), 0);
    EXPECT_EQ(srgb8(std::numeric_limits<float>::infinity()), 255);
}

TEST(Srgb8, ReturnsEveryCode) {
    for (int code = 0; code < 256; ++code)
        EXPECT_EQ(srgb8(linearFromSrgb8()[static_cast<std::size_t>(code)]), code);
}

TEST(SrgbTransfer, ThereAndBackIsTheIdentity) {
    // The standard's two branches miss each other by 3e-8 at the joint; float adds its own.
    for (float v = 0.0f; v <= 1.0f; v += 0.001f) {
        EXPECT_NEAR(tonemap::linearFromSrgb(tonemap::srgbFromLinear(vec3(v))).y, v, 1e-6f);
        EXPECT_NEAR(tonemap::srgbFromLinear(vec3(v)).x, srgb(v), 1e-6) << v;
    }
}

TEST(Tonemap, EveryOperatorMapsBlackToBlack) {
    for (const auto& [tonemap, name] : kTonemapSpellings)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(displayed(vec3(0), tonemap, 1.0f)[c], 0.0f, 1e-6f) << name;
}

TEST(Tonemap, EveryOperatorIsMonotoneAndGreyStaysGrey) {
    for (const auto& [tonemap, name] : kTonemapSpellings) {
        vec3 last(0.0f);
        for (float v = 1e-4f; v < 1e4f; v *= 1.01f) {
            const vec3 now = displayed(vec3(v), tonemap, 1.0f);
            // The fitted matrices are given to four or five digits.
            EXPECT_NEAR(now.x, now.y, 2e-3f) << name << " " << v;
            EXPECT_NEAR(now.z, now.y, 2e-3f) << name << " " << v;
            // AgX's polynomial sags by 1e-3 close to white.
            EXPECT_GE(now.y, last.y - 1.5e-3f) << name << " " << v;
            EXPECT_LE(now.y, 1.0f);
            last = now;
        }
        EXPECT_GT(last.y, 0.97f) << name;
    }
}

TEST(Tonemap, ReinhardHalvesOne) {
    EXPECT_EQ(displayed(vec3(1), Tonemap::reinhard, 1.0f), vec3(0.5f));
}

TEST(Tonemap, NeutralKeepsBaseColoursButForFourPercent) {
    const vec3 c(0.5f, 0.3f, 0.1f);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(displayed(c, Tonemap::neutral, 1.0f)[k], c[k] - 0.04f, 1e-6f);
    // 0.8, the specification's start of compression, becomes 0.76.
    EXPECT_NEAR(displayed(vec3(0.8f), Tonemap::neutral, 1.0f).y, 0.76f, 1e-6f);
}

TEST(Tonemap, AgxPutsMiddleGreyAtItsPivot) {
    // Sobotka's curve takes 0.18, 10 of the 16.5 stops above black, to 0.5 of the encoded range;
    // the polynomial fits it to 4e-3 and 2.2 decodes it.
    EXPECT_NEAR(displayed(vec3(0.18f), Tonemap::agx, 1.0f).y, std::pow(0.5f, 2.2f), 5e-3f);
}

TEST(Tonemap, AcesPutsMiddleGreyNearItself) {
    // Hill's fit gives 0.1 for 0.18 on its own; with the pre-exposure of 1 / 0.6 about 0.21.
    EXPECT_NEAR(displayed(vec3(0.18f), Tonemap::aces, 1.0f).y, 0.21f, 0.01f);
    EXPECT_NEAR(displayed(vec3(0.18f * 0.6f), Tonemap::aces, 1.0f).y, 0.106f, 0.01f);
}

TEST(Tonemap, ExposureIsAFactorOfTwoForEachStop) {
    EXPECT_EQ(tonemap::exposureFactor(3.0f), 8.0f);
    EXPECT_EQ(displayed(vec3(0.25f), Tonemap::none, tonemap::exposureFactor(1.0f)), vec3(0.5f));
}

TEST(Displayed, TakesEveryFloat) {
    const float inf = std::numeric_limits<float>::infinity();
    for (const auto& [tonemap, name] : kTonemapSpellings) {
        for (float v : {inf, -inf, std::nanf(""), 3e38f, -1.0f, 1e-40f})
            for (int c = 0; c < 3; ++c) {
                const float out = displayed(vec3(v, 0.5f, 0.0f), tonemap, 4.0f)[c];
                EXPECT_TRUE(out >= 0.0f && out <= 1.0f) << name << " " << v;
            }
    }
}

}  // namespace
}  // namespace tukor
