#include "texture/wrap.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace etendue {
namespace {

std::vector<int> wrapped(TextureWrap wrap, int begin, int end, int n) {
    std::vector<int> result;
    for (int i = begin; i < end; ++i) result.push_back(wrap_index(wrap, i, n));
    return result;
}

TEST(WrapIndex, EachModeOverItsRange) {
    EXPECT_EQ(wrapped(TextureWrap::Repeat, -1, 4, 3), (std::vector{2, 0, 1, 2, 0}));
    EXPECT_EQ(wrapped(TextureWrap::Mirror, -1, 7, 3), (std::vector{0, 0, 1, 2, 2, 1, 0, 0}));
    EXPECT_EQ(wrapped(TextureWrap::Clamp, -1, 4, 3), (std::vector{0, 0, 1, 2, 2}));
    EXPECT_EQ(wrapped(TextureWrap::Black, -1, 4, 3), (std::vector{kOutside, 0, 1, 2, kOutside}));
}

TEST(WrapIndex, OneTexelIsEnough) {
    EXPECT_EQ(wrapped(TextureWrap::Repeat, -1, 2, 1), (std::vector{0, 0, 0}));
    EXPECT_EQ(wrapped(TextureWrap::Mirror, -1, 3, 1), (std::vector{0, 0, 0, 0}));
    EXPECT_EQ(wrapped(TextureWrap::Clamp, -1, 2, 1), (std::vector{0, 0, 0}));
}

TEST(ReduceCoordinate, StaysInRangeForAnyFiniteValue) {
    for (const double u : {-1e300, -1e17, -1e-300, -1e-17, 0.0, 1.0, 2.0, 1e17, 1e300}) {
        for (const TextureWrap wrap :
             {TextureWrap::Repeat, TextureWrap::Mirror, TextureWrap::Clamp, TextureWrap::Black}) {
            const double reduced = reduce_coordinate(wrap, u);
            EXPECT_GE(reduced, -2) << u;
            EXPECT_LE(reduced, 3) << u;
            // and the indices that follow from it are texels
            constexpr int n = 4;
            const int first = static_cast<int>(std::floor(reduced * n - 0.5));
            for (const int i : {wrap_index(wrap, first, n), wrap_index(wrap, first + 1, n)}) {
                EXPECT_LT(i, n) << u;
                EXPECT_GE(i, wrap == TextureWrap::Black ? kOutside : 0) << u;
            }
        }
    }
}

}  // namespace
}  // namespace etendue
