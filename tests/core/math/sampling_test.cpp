#include "math/sampling.h"

#include <gtest/gtest.h>

#include "support/chi2.h"

namespace etendue::test {
namespace {

TEST(Sampling, ConcentricDiskIsUniform) {
    const PlaneSampler sampler = [](Rng& rng) { return sample_concentric_disk(rng.next_2d()); };
    // The disk's rim is a jump no quadrature over squares sees exactly: map it back by the square root of the radius.
    const PlaneSampler polar = [&](Rng& rng) {
        const Vec2 p = *sampler(rng);
        const double turn = std::atan2(p.y, p.x) / (2 * kPi);
        return Vec2{p.x * p.x + p.y * p.y, turn < 0 ? turn + 1 : turn};
    };
    EXPECT_TRUE(passes(chi2_square(polar, [](const Vec2&) { return 1.0; }, {})));
}

TEST(Sampling, ConcentricDiskKeepsToItsEdges) {
    for (double u : {0.0, 0.25, 0.5, 0.75, kOneMinusEpsilon}) {
        for (double v : {0.0, 0.25, 0.5, 0.75, kOneMinusEpsilon}) {
            const Vec2 p = sample_concentric_disk({u, v});
            EXPECT_LE(std::hypot(p.x, p.y), 1 + 1e-15);
        }
    }
    EXPECT_EQ(sample_concentric_disk({0.5, 0.5}).x, 0);
}

TEST(Sampling, DirectionsHaveTheDensitiesTheyClaim) {
    const auto hemisphere = [](Rng& rng) { return sample_cosine_hemisphere(rng.next_2d()); };
    EXPECT_TRUE(passes(chi2_sphere(hemisphere, [](const Vec3& w) { return std::max(0.0, w.z) / kPi; }, {}, {})));
    const auto sphere = [](Rng& rng) { return sample_uniform_sphere(rng.next_2d()); };
    EXPECT_TRUE(passes(chi2_sphere(sphere, [](const Vec3&) { return 1 / (4 * kPi); }, {}, {})));
}

TEST(Sampling, ConesAreUniformDownToTheNarrowest) {
    for (double width : {1.5, 0.1, 1e-6, 1e-14}) {
        const PlaneSampler cone = [width](Rng& rng) {
            const Vec3 w = sample_uniform_cone(rng.next_2d(), width);
            const double turn = std::atan2(w.y, w.x) / (2 * kPi);
            const double sin2 = w.x * w.x + w.y * w.y;
            const double versine = w.z < 0 ? 1 - w.z : one_minus_cos(sin2);
            return Vec2{versine / width, turn < 0 ? turn + 1 : turn};
        };
        EXPECT_TRUE(passes(chi2_square(cone, [](const Vec2&) { return 1.0; }, {}))) << width;
    }
}

TEST(Sampling, TrianglesAreUniform) {
    const PlaneSampler triangle = [](Rng& rng) {
        const Vec2 b = sample_uniform_triangle(rng.next_2d());
        EXPECT_GE(1 - b.x - b.y, -1e-15);
        // (b.x + b.y)^2 and the share of b.y are independent and uniform.
        const double sum = b.x + b.y;
        return Vec2{sum * sum, sum > 0 ? b.y / sum : 0.5};
    };
    EXPECT_TRUE(passes(chi2_square(triangle, [](const Vec2&) { return 1.0; }, {})));
}

TEST(Sampling, OneMinusCosKeepsItsDigits) {
    for (double angle : {1e-9, 1e-5, 0.1, 1.0, kPi / 2}) {
        const double half = std::sin(angle / 2);
        const double s = std::sin(angle);
        EXPECT_NEAR(one_minus_cos(s * s) / (2 * half * half), 1, 1e-7) << angle;
    }
}

}  // namespace
}  // namespace etendue::test
