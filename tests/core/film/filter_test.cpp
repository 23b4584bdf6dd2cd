#include "film/filter.h"

#include <gtest/gtest.h>

#include <etendue/error.h>

#include "math/constants.h"
#include "support/chi2.h"

namespace etendue::test {
namespace {

constexpr std::array kKinds{FilterKind::Box, FilterKind::Triangle, FilterKind::Gaussian};

/// Splats are weighted with the density that camera samples are drawn from, else the two would estimate different
/// pictures.
TEST(Filter, SamplesAreDrawnFromTheDensity) {
    for (FilterKind kind : kKinds) {
        for (double radius : {0.5, 1.5, 3.0}) {
            const Filter filter({kind, radius});
            const PlaneSampler sampler = [&](Rng& rng) { return filter.sample(rng.next_2d()); };
            const PlaneDensity density = [&](const Vec2& p) { return filter.eval(p); };
            const Grid grid{even_edges(-radius, radius, 16), even_edges(-radius, radius, 16)};
            const Chi2Result result = chi2_plane(sampler, density, grid, {});
            EXPECT_TRUE(passes(result)) << radius;
            EXPECT_NEAR(result.integral, 1, 1e-4);
        }
    }
}

TEST(Filter, IntegratesToOne) {
    for (FilterKind kind : kKinds) {
        for (double radius : {0.25, 0.5, 2.0}) {
            const Filter filter({kind, radius});
            double sum = 0;
            constexpr int kSteps = 1000;  // midpoint rule; the round rim of the Gaussian costs some 1e-5
            for (int i = 0; i < kSteps; ++i) {
                for (int j = 0; j < kSteps; ++j) {
                    sum += filter.eval({radius * (2 * (i + 0.5) / kSteps - 1), radius * (2 * (j + 0.5) / kSteps - 1)});
                }
            }
            EXPECT_NEAR(sum * 4 * radius * radius / kSteps / kSteps, 1, 1e-4);
        }
    }
}

TEST(Filter, EndsAtItsRadius) {
    for (FilterKind kind : kKinds) {
        const Filter filter({kind, 1.5});
        EXPECT_EQ(filter.radius(), 1.5);
        EXPECT_GT(filter.eval({1.49, 0}), 0);
        EXPECT_GT(filter.eval({0, -1.49}), 0);
        EXPECT_EQ(filter.eval({1.51, 0}), 0);
        EXPECT_EQ(filter.eval({0, -1.51}), 0);
        EXPECT_EQ(filter.eval({1.4, 1.4}) > 0, kind != FilterKind::Gaussian);  // round
    }
}

TEST(Filter, HasTheShapesItClaims) {
    EXPECT_DOUBLE_EQ(Filter({FilterKind::Box, 0.5}).eval({0.3, -0.2}), 1);
    EXPECT_DOUBLE_EQ(Filter({FilterKind::Triangle, 2}).eval({1, -0.5}), 0.5 * 0.75 / 4);
    const Filter gaussian({FilterKind::Gaussian, 3});  // sigma 1
    EXPECT_NEAR(gaussian.eval({1, 1}) / gaussian.eval({0, 0}), std::exp(-1.0), 1e-12);
    EXPECT_NEAR(gaussian.eval({0, 0}), 1 / (2 * kPi * (1 - std::exp(-4.5))), 1e-12);
}

TEST(Filter, RefusesRadiiThatMeanNothing) {
    for (double radius : {0.0, -1.0, kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(Filter({FilterKind::Box, radius}), SettingsError);
    }
}

}  // namespace
}  // namespace etendue::test
