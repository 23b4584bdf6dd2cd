#include "texture/half_float.h"

#include <cmath>

#include <gtest/gtest.h>

namespace etendue {
namespace {

TEST(HalfToFloat, EveryFiniteHalf) {
    for (std::uint32_t bits = 0; bits < 0x10000U; ++bits) {
        const int exponent = static_cast<int>(bits >> 10 & 31U);
        if (exponent == 31) continue;
        const int mantissa = static_cast<int>(bits & 1023U);
        const double magnitude = exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25);
        const double expected = (bits & 0x8000U) != 0 ? -magnitude : magnitude;
        EXPECT_EQ(static_cast<double>(half_to_float(static_cast<std::uint16_t>(bits))), expected) << bits;
    }
}

TEST(HalfToFloat, InfinityAndNan) {
    EXPECT_EQ(half_to_float(0x7c00), INFINITY);
    EXPECT_EQ(half_to_float(0xfc00), -INFINITY);
    EXPECT_TRUE(std::isnan(half_to_float(0x7e01)));
}

}  // namespace
}  // namespace etendue
