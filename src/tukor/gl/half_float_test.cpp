#include "tukor/gl/half_float.h"

#include <cmath>

#include <gtest/gtest.h>

namespace tukor::gl {
namespace {

/// By the definition of the format: ten bits of fraction, exponents from 2^-14, zero and denormals
/// below.
double floatFromHalf(std::uint16_t half) {
    const int exponent = half >> 10 & 31;
    const int fraction = half & 1023;
    const double magnitude =
        exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
    return half & 0x8000 ? -magnitude : magnitude;
}

TEST(HalfFloat, KeepsEveryHalf) {
    for (std::uint32_t half = 0; half < 0x7c00; ++half) {
        const auto bits = static_cast<std::uint16_t>(half);
        ASSERT_EQ(halfFromFloat(static_cast<float>(floatFromHalf(bits))), bits);
    }
}

TEST(HalfFloat, RoundsToTheNearestAndTiesToEven) {
    for (std::uint32_t half = 0; half + 1 < 0x7c00; ++half) {
        const double low = floatFromHalf(static_cast<std::uint16_t>(half));
        const double high = floatFromHalf(static_cast<std::uint16_t>(half + 1));
        const auto middle = static_cast<float>(0.5 * (low + high));
        ASSERT_EQ(halfFromFloat(middle), half + (half & 1)) << half;
        ASSERT_EQ(halfFromFloat(std::nextafter(middle, 0.0f)), half);
        ASSERT_EQ(halfFromFloat(std::nextafter(middle, 1e9f)), half + 1);
    }
    EXPECT_EQ(halfFromFloat(kLargestHalf), 0x7bff);
    EXPECT_EQ(halfFromFloat(-1.0f), 0xbc00);
}

}  // namespace
}  // namespace tukor::gl
