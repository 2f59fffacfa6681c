#include "tukor/image/compare.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"
#include "tukor/image/display.h"

namespace tukor {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

float linear(int code) {
    return linearFromSrgb8()[static_cast<std::size_t>(code)];
}

Image grey(int width, int height, float value) {
    Image image(width, height);
    for (glm::vec3& pixel : image.pixels()) pixel = glm::vec3(value);
    return image;
}

TEST(CompareImages, EqualPicturesAreNotApart) {
    const Comparison c = compareImages(grey(4, 3, 0.5f), grey(4, 3, 0.5f));
    EXPECT_EQ(c.rmse8, 0.0);
    EXPECT_EQ(c.maximum8, 0);
    EXPECT_EQ(c.withinTwo8, 1.0);
    EXPECT_EQ(c.relativeMaximum, 0.0);
    EXPECT_TRUE(c.worst.empty());
}

TEST(CompareImages, CountsInCodesOfSrgb) {
    Image a = grey(10, 1, linear(100));
    a.at(3, 0) = glm::vec3(linear(106), linear(100), linear(92));
    a.at(7, 0).x = linear(102);
    const Comparison c = compareImages(a, grey(10, 1, linear(100)));
    EXPECT_DOUBLE_EQ(c.rmse8, std::sqrt((36.0 + 64.0 + 4.0) / 30.0));
    EXPECT_DOUBLE_EQ(c.mean8, (6.0 + 8.0 + 2.0) / 30.0);
    EXPECT_EQ(c.maximum8, 8);
    EXPECT_DOUBLE_EQ(c.withinTwo8, 0.9);
    ASSERT_EQ(c.worst.size(), 2u);
    EXPECT_EQ(c.worst[0].column, 3);
    EXPECT_EQ(c.worst[0].difference8, 8);
    EXPECT_EQ(c.worst[0].a, a.at(3, 0));
    EXPECT_EQ(c.worst[1].column, 7);
}

TEST(CompareImages, ClipsWhatTheScreenClipsButNotTheRadiance) {
    const Comparison c = compareImages(grey(2, 2, 3.0f), grey(2, 2, 2.0f));
    EXPECT_EQ(c.rmse8, 0.0);
    EXPECT_NEAR(c.relativeRmse, 1.0 / 2.02, 1e-6);
    EXPECT_NEAR(c.relativeMean, 1.0 / 2.02, 1e-6);
    EXPECT_NEAR(c.relativeMaximum, 1.0 / 2.02, 1e-6);
}

TEST(CompareImages, ListsTheTenWorstInOrder) {
    Image a = grey(30, 2, 0.0f);
    for (int i = 0; i < 30; ++i) a.at(i, 1).y = linear((i * 7) % 30);
    const Comparison c = compareImages(a, grey(30, 2, 0.0f));
    ASSERT_EQ(c.worst.size(), 10u);
    for (int i = 0; i < 10; ++i) {
        EXPECT_EQ(c.worst[static_cast<std::size_t>(i)].difference8, 29 - i);
        EXPECT_EQ(c.worst[static_cast<std::size_t>(i)].row, 1);
        EXPECT_EQ(c.worst[static_cast<std::size_t>(i)].column * 7 % 30, 29 - i);
    }
}

TEST(CompareImages, ANanIsAsFarAsCanBe) {
    Image a = grey(2, 1, 0.5f);
    a.at(1, 0).z = std::nanf("");
    const Comparison c = compareImages(a, grey(2, 1, 0.5f));
    EXPECT_EQ(c.nonFinite, 1u);
    EXPECT_EQ(c.maximum8, 255);
    EXPECT_EQ(c.relativeMaximum, 0.0);
    EXPECT_THAT(report(c), HasSubstr("1 components are not finite"));
    EXPECT_THAT(report(c), HasSubstr("(1, 0): 255 codes apart"));
}

TEST(CompareImages, RefusesDifferentSizes) {
    EXPECT_THAT(
        [] { (void)compareImages(Image(2, 3), Image(3, 2)); },
        ThrowsMessage<Error>(HasSubstr("pictures of 2 x 3 and 3 x 2 pixels cannot be compared")));
    EXPECT_THAT([] { (void)heatMap(Image(2, 3), Image(3, 2)); },
                ThrowsMessage<Error>(HasSubstr("")));
}

TEST(HeatMap, GrowsFromBlackToWhite) {
    Image a(64, 1);
    for (int i = 0; i < 64; ++i) a.at(i, 0) = glm::vec3(linear(i));
    const Image map = heatMap(a, Image(64, 1));
    EXPECT_EQ(map.at(0, 0), glm::vec3(0.0f));
    const auto luminance = [&](int i) {
        return glm::dot(map.at(i, 0), glm::vec3(0.2126f, 0.7152f, 0.0722f));
    };
    for (int i = 1; i <= 32; ++i) EXPECT_GT(luminance(i), luminance(i - 1)) << i;
    EXPECT_NEAR(luminance(32), 1.0f, 1e-5f);
    EXPECT_EQ(map.at(63, 0), map.at(32, 0));
}

}  // namespace
}  // namespace tukor
