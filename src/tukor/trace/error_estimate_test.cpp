#include "tukor/trace/error_estimate.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

namespace tukor::trace {
namespace {

/// Of `side` squared pixels, each with two samples that differ by about 10 codes, and `rays` each.
Accumulation twiceSampled(int side, const std::function<float(int pixel)>& rays) {
    Accumulation picture(side, side);
    std::mt19937 random(3);
    for (int sample = 0; sample < 2; ++sample)
        for (int i = 0; i < side * side; ++i) {
            const float radiance = std::uniform_real_distribution<float>(0.2f, 0.3f)(random);
            picture.add(static_cast<std::size_t>(i), {glm::vec3(radiance), 1.0f, rays(i)}, 1);
        }
    return picture;
}

std::ptrdiff_t chosenIn(const Accumulation& picture) {
    return std::count(picture.active.begin(), picture.active.end(), 1);
}

TEST(ErrorEstimate, JustAboveTheTargetFewPixelsGoOn) {
    Accumulation picture = twiceSampled(64, [](int) { return 4.0f; });
    ErrorEstimate estimate;
    estimate.update(picture);
    const double now = estimate.rmse().value();
    ASSERT_TRUE(estimate.chooseActive(picture, 0.5 * now, 1024));
    EXPECT_GT(chosenIn(picture), 64 * 64 / 2);
    ASSERT_TRUE(estimate.chooseActive(picture, 0.99 * now, 1024));
    EXPECT_LT(chosenIn(picture), 64 * 64 / 10);
}

TEST(ErrorEstimate, CheapPixelsGoOnBeforeDearOnes) {
    Accumulation picture = twiceSampled(64, [](int i) { return i < 64 * 32 ? 2.0f : 40.0f; });
    ErrorEstimate estimate;
    estimate.update(picture);
    ASSERT_TRUE(estimate.chooseActive(picture, 0.9 * estimate.rmse().value(), 1024));
    const auto middle = picture.active.begin() + 64 * 32;
    EXPECT_GT(std::count(picture.active.begin(), middle, 1), 64);
    EXPECT_LT(std::count(middle, picture.active.end(), 1), 64);
}

TEST(ErrorEstimate, PixelsDoNotGoOnForThoseThatMayNot) {
    Accumulation picture(64, 64);
    std::mt19937 random(3);
    for (int sample = 0; sample < 2; ++sample)
        for (int i = 0; i < 64 * 64; ++i) {
            const float noise = i < 64 * 32 ? 0.1f : 1e-4f;
            const std::uint32_t count = i < 64 * 34 ? 16 : 1;  // also of noisy pixels' neighbours
            const float radiance =
                0.2f + std::uniform_real_distribution<float>(0.0f, noise)(random);
            picture.add(static_cast<std::size_t>(i),
                        {static_cast<float>(count) * glm::vec3(radiance), 1.0f, 1.0f}, count);
        }
    ErrorEstimate estimate;
    estimate.update(picture);
    EXPECT_FALSE(estimate.chooseActive(picture, 0.5 * estimate.rmse().value(), 32));
    ASSERT_TRUE(estimate.chooseActive(picture, 0.5 * estimate.rmse().value(), 64));
    EXPECT_GT(chosenIn(picture), 64 * 32 / 2);
    EXPECT_EQ(std::count(picture.active.begin() + 64 * 34, picture.active.end(), 1), 0);
}

TEST(ErrorEstimate, DoubtsLampsThatWideLookUpsSaw) {
    Accumulation picture(8, 8);
    PixelSum clean, doubtful;
    clean.radiance = doubtful.radiance = glm::vec3(0.5f);
    doubtful.doubtful = glm::vec3(0.3f);
    for (int sample = 0; sample < 2; ++sample)
        for (std::size_t i = 0; i < 64; ++i) picture.add(i, i % 4 == 0 ? doubtful : clean, 1);
    ErrorEstimate estimate;
    estimate.update(picture);
    const double step =
        static_cast<double>(srgbCode(glm::vec3(0.5f)).x - srgbCode(glm::vec3(0.2f)).x);
    const double doubt = step * step / 3.0 / 4.0;
    EXPECT_NEAR(*estimate.rmse(), std::sqrt(doubt), 1e-4);
    EXPECT_NEAR(*estimate.noise(), 0.0, 1e-6);
    EXPECT_NEAR(estimate.noiseWithin(2.0 * std::sqrt(doubt)), std::sqrt(3.0 * doubt), 1e-4);
    EXPECT_NEAR(estimate.noiseWithin(std::sqrt(doubt)), std::sqrt(0.5 * doubt), 1e-4);
}

TEST(ErrorEstimate, BeyondWhiteCountsWhereItIsAsked) {
    const auto goesOn = [](bool beyondWhite) {
        Accumulation picture(8, 8, false, beyondWhite);
        for (int sample = 0; sample < 2; ++sample)
            for (std::size_t i = 0; i < 64; ++i) {
                const float lamp = i < 32 ? 10.0f + 30.0f * static_cast<float>(sample) : 0.5f;
                picture.add(i, {glm::vec3(lamp), 1.0f, 1.0f}, 1);
            }
        ErrorEstimate estimate;
        estimate.update(picture);
        EXPECT_EQ(*estimate.noise(), 0.0) << "displays show white";
        return estimate.chooseBright(picture, 0.5, 64);
    };
    EXPECT_TRUE(goesOn(true));
    EXPECT_FALSE(goesOn(false));
}

TEST(Accumulation, SeesShadowsOnNothing) {
    const auto step = [](bool transparent) {
        Accumulation picture(1, 1, transparent);
        PixelSum sum;
        picture.add(0, sum, 1);
        sum.coverage = 1.0f;
        picture.add(0, sum, 1);
        return picture.halves[0];
    };
    EXPECT_GT(step(true), 0.0f);
    EXPECT_EQ(step(false), 0.0f);
}

TEST(Accumulation, CountsWhatMoreSamplesWouldNotChange) {
    Accumulation picture(2, 1);
    for (int sample = 0; sample < 2; ++sample)
        for (std::size_t i = 0; i < 2; ++i)
            picture.add(i, {glm::vec3(0.1f + 0.3f * static_cast<float>(sample)), 1.0f, 3.0f}, 1);
    const glm::vec3 mean = picture.mean(0);
    picture.settle(0, 16);
    EXPECT_EQ(picture.samples[0], 16u);
    EXPECT_EQ(picture.mean(0), mean);
    EXPECT_EQ(picture.sums[0].rays, 48.0f);
    EXPECT_EQ(picture.halves[0], 0.0f) << "no error is left";
    EXPECT_GT(picture.halves[1], 0.0f);
    EXPECT_EQ(picture.samples[1], 2u);
}

}  // namespace
}  // namespace tukor::trace
