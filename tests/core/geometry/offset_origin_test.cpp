#include <gtest/gtest.h>

#include "core/math/random_math.h"
#include "geometry/ray.h"

namespace etendue::test {
namespace {

bool is_float(double x) { return static_cast<double>(static_cast<float>(x)) == x; }

// The origin of a ray must lie beyond the error's reach on the side to which the ray goes, and not farther than needed,
// at any scale.
TEST(OffsetOrigin, LeavesTheErrorBehindAtAnyScale) {
    Rng rng(1, 0, 0);
    for (double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
        for (int i = 0; i < 10000; ++i) {
            const Vec3 p = random_point(rng, scale);
            const Vec3 error = abs(p) * (4 * kFloatRounding);
            const Vec3 n = random_direction(rng);
            const Vec3 w = random_direction(rng);
            const Vec3 o = offset_origin(p, error, n, w);
            ASSERT_TRUE(is_float(o.x) && is_float(o.y) && is_float(o.z));
            const double reach = dot(abs(n), error);
            const double height = dot(o - p, n) * (dot(w, n) < 0 ? -1 : 1);
            EXPECT_GE(height, reach * (1 - 1e-9));
            // A float's spacing is at most 2^-23 of the value: that much more on each axis.
            const double most = 2 * kFloatRounding * dot(abs(n), abs(p) + error * 2) + 1e-44;
            EXPECT_LE(height, reach + most * (1 + 1e-6));
        }
    }
}

TEST(OffsetOrigin, LeavesFreePointsWhereTheyAre) {
    const Vec3 p{0.25, -3, 1e-3F};
    EXPECT_EQ(offset_origin(p, {}, {}, {0, 0, 1}), p);
    const Vec3 q{0.1, 0.2, 0.3};
    EXPECT_LE(length(offset_origin(q, {}, {}, {0, 0, 1}) - q), 0.4 * kFloatRounding);
}

TEST(OffsetOrigin, RoundsTowardsTheSideAsked) {
    const double third = 1.0 / 3;
    EXPECT_GE(detail::round_to_float(third, 1), third);
    EXPECT_LE(detail::round_to_float(third, -1), third);
    EXPECT_GE(detail::round_to_float(-third, 1), -third);
    EXPECT_LE(detail::round_to_float(-third, -1), -third);
    EXPECT_EQ(detail::round_to_float(0.5, 1), 0.5);
    EXPECT_EQ(detail::round_to_float(0, -1), 0);
}

}  // namespace
}  // namespace etendue::test
