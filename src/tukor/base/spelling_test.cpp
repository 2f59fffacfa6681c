#include "tukor/base/spelling.h"

#include <array>
#include <string>

#include <gtest/gtest.h>

namespace tukor {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
    EXPECT_EQ(editDistance("gold", "gold"), 0);
    EXPECT_EQ(editDistance("GOLD", "gold"), 0);
    EXPECT_EQ(editDistance("glod", "gold"), 1);
    EXPECT_EQ(editDistance("gol", "gold"), 1);
    EXPECT_EQ(editDistance("golds", "gold"), 1);
    EXPECT_EQ(editDistance("bold", "gold"), 1);
    EXPECT_EQ(editDistance("", "gold"), 4);
    EXPECT_EQ(editDistance("silver", "water"), editDistance("water", "silver"));
}

TEST(NearestName, FindsTheOneThatWasMeantOrNone) {
    constexpr std::array<std::string_view, 4> names = {"gold", "silver", "glass", "crown-glass"};
    EXPECT_EQ(nearestName("glod", names), "gold");
    EXPECT_EQ(nearestName("Sliver", names), "silver");
    EXPECT_EQ(nearestName("crownglass", names), "crown-glass");
    EXPECT_EQ(nearestName("unobtainium", names), "");
    EXPECT_EQ(nearestName("", names), "");
    EXPECT_EQ(nearestName(std::string(100000, 'g'), names), "");
}

}  // namespace
}  // namespace tukor
