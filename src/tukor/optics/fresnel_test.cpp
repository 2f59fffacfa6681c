#include "tukor/optics/fresnel.h"

#include <gtest/gtest.h>

#include "tukor/optics/absorption.h"
#include "tukor/optics/directions.h"

namespace tukor::optics {
namespace {

TEST(FresnelDielectric, IsOneBeyondTheCriticalAngle) {
    EXPECT_EQ(fresnelDielectric(0.1f, 1.0f / 1.5f), 1.0f);
}

}  // namespace
}  // namespace tukor::optics
