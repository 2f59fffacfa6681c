#include "tukor/environment/repair.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tukor/base/error.h"

namespace tukor {
namespace {

using testing::ElementsAre;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Image constant(int width, int height, float value) {
    Image image(width, height);
    for (glm::vec3& pixel : image.pixels()) pixel = glm::vec3(value);
    return image;
}

TEST(RepairRadiance, LeavesSoundRadianceAlone) {
    Image image = constant(5, 4, 0.5f);
    image.at(2, 2) = {0.0f, 1e30f, 1e-40f};
    const RepairCount count = repairRadiance(image);
    EXPECT_EQ(count.notFinite, 0);
    EXPECT_EQ(count.negative, 0);
    EXPECT_EQ(image.at(2, 2), glm::vec3(0.0f, 1e30f, 1e-40f));
    EXPECT_TRUE(describeRepairs(count).empty());
}

TEST(RepairRadiance, ReplacesEachKindByItsRule) {
    Image image = constant(5, 5, 1.0f);
    image.at(1, 1) = glm::vec3(9.0f);
    image.at(2, 2) = {kNan, kInfinity, -kInfinity};
    image.at(4, 4) = {1.0f, -0.25f, 1.0f};
    const RepairCount count = repairRadiance(image);
    EXPECT_EQ(image.at(2, 2), glm::vec3(2.0f, 9.0f, 0.0f));  // (9 + 7 * 1) / 8, the largest, 0
    EXPECT_EQ(image.at(4, 4), glm::vec3(1.0f, 0.0f, 1.0f));
    EXPECT_THAT(describeRepairs(count),
                ElementsAre("1 pixel not finite, replaced by the neighbours",
                            "1 pixel with negative radiance, set to 0"));
}

TEST(RepairRadiance, TakesWhatOverflowsInSumsForInfinite) {
    Image image = constant(5, 5, 1.0f);
    image.at(2, 2) = {3e38f, -3e38f, 1e30f};
    image.at(3, 2) = {4.0f, 3e30f, 1.0f};
    const RepairCount count = repairRadiance(image);
    EXPECT_EQ(image.at(2, 2), glm::vec3(4.0f, 0.0f, 1e30f));
    EXPECT_EQ(image.at(3, 2), glm::vec3(4.0f, 1.0f, 1.0f));
    EXPECT_EQ(count.notFinite, 2);
}

TEST(RepairRadiance, TakesNeighboursOverTheSeamAndZeroWhereThereIsNone) {
    Image image = constant(4, 1, kNan);
    image.at(3, 0) = glm::vec3(5.0f);
    const RepairCount count = repairRadiance(image);
    EXPECT_EQ(image.at(0, 0), glm::vec3(5.0f));
    EXPECT_EQ(image.at(1, 0), glm::vec3(0.0f));
    EXPECT_EQ(count.notFinite, 3);
}

TEST(RepairPictures, RefusesWhatIsMostlyNoRadiance) {
    std::vector<Image> pictures(6, Image(4, 4));
    for (int i = 0; i < 8; ++i) pictures[5].at(i % 4, i / 4) = glm::vec3(std::nanf(""));
    EXPECT_EQ(repairPictures("a", pictures).size(), 1u);  // exactly half of one
    for (glm::vec3& pixel : pictures[5].pixels()) pixel.y = std::nanf("");
    try {
        (void)repairPictures("a.dds", pictures);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "a.dds: 16 of 16 pixels are not finite; the file is damaged");
    }
}

}  // namespace
}  // namespace tukor
