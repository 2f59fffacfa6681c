#include "tukor/app/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tukor {
namespace {

TEST(WarningsOf, CountsTheRaysThatFoundAHole) {
    Rendering rendering;
    rendering.rays = 1000;
    EXPECT_TRUE(warningsOf(rendering).empty());
    rendering.leaks = 2;
    rendering.inconsistencies = 1;
    EXPECT_THAT(warningsOf(rendering),
                testing::ElementsAre(testing::StartsWith("3 of 1000 rays left a solid")));
}

TEST(WarningsOf, DoesNotBlameAModelForOneRayInTenMillion) {
    Rendering rendering;
    rendering.rays = 30'000'000;
    rendering.inconsistencies = 2;
    EXPECT_TRUE(warningsOf(rendering).empty());
    rendering.inconsistencies = 3;
    EXPECT_FALSE(warningsOf(rendering).empty());
}

TEST(SummaryOf, SaysWhatMoreSamplesDoNotTakeOff) {
    Rendering rendering;
    rendering.error = 0.81;
    rendering.noise = 0.80;
    EXPECT_THAT(summaryOf(rendering, 2.0), testing::EndsWith("expected RMSE 0.81"));
    rendering.noise = 0.35;
    EXPECT_THAT(
        summaryOf(rendering, 2.0),
        testing::EndsWith(
            "expected RMSE 0.81 (noise 0.35, the rest suns and lamps that glint in glass)"));
}

}  // namespace
}  // namespace tukor
