#include "tukor/optics/dispersion.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tukor::optics
