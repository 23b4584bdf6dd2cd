#include "math/distribution.h"

#include <cmath>

#include <gtest/gtest.h>
#include <boost/math/distributions/chi_squared.hpp>

#include "math/rng.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

TEST(Distribution, DrawsInProportion) {
    const std::vector<double> weights{0.5, 0, 3, 1e-3, 0, 1.5, 2};
    const Distribution d(weights);
    const int n = samples(200000);
    std::vector<double> counts(weights.size());
    Estimate u;
    Rng rng(1, 0, 0);
    for (int i = 0; i < n; ++i) {
        const Distribution::Sample s = d.sample(rng.next_1d());
        counts[s.index] += 1;
        u.add(s.u);
    }
    double statistic = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        EXPECT_NEAR(d.pmf(i), weights[i] / 7.001, 1e-15);
        if (weights[i] == 0) {
            EXPECT_EQ(counts[i], 0);
            continue;
        }
        const double expected = n * d.pmf(i);
        statistic += (counts[i] - expected) * (counts[i] - expected) / expected;
    }
    // Five entries can be drawn; a right sampler fails once in a million seeds.
    EXPECT_LT(statistic, boost::math::quantile(boost::math::complement(boost::math::chi_squared(4), 1e-6)));
    EXPECT_TRUE(agrees(u, 0.5));
}

TEST(Distribution, NeverDrawsZeroWeightsAtTheEnds) {
    const Distribution d({0, 0, 1, 0, 2, 0, 0});
    for (double u : {0.0, 1e-300, 1.0 / 3 - 1e-16, 1.0 / 3, kOneMinusEpsilon, 1.0}) {
        const Distribution::Sample s = d.sample(u);
        EXPECT_TRUE(s.index == 2 || s.index == 4) << u;
        EXPECT_GE(s.u, 0);
        EXPECT_LT(s.u, 1);
    }
    EXPECT_EQ(d.sample(0).index, 2U);
    EXPECT_EQ(d.sample(kOneMinusEpsilon).index, 4U);
}

TEST(Distribution, EndsWhereRoundingPushesPastTheTotal) {
    // (1 - 2^-53) * total rounds up to total for such sums; the last entries weigh nothing.
    std::vector<double> weights(1000, 0.1);
    weights.push_back(0);
    const Distribution d(weights);
    for (double u : {kOneMinusEpsilon, 1 - 0x1p-52}) EXPECT_EQ(d.sample(u).index, 999U);
}

TEST(Distribution, RemapsTheNumberLinearly) {
    const Distribution d({1, 3});
    EXPECT_NEAR(d.sample(0.125).u, 0.5, 1e-15);
    EXPECT_NEAR(d.sample(0.25 + 0.75 * 0.3).u, 0.3, 1e-15);
}

TEST(Distribution, SpansManyOrdersOfMagnitude) {
    const Distribution d({1e-30, 1e30, 1e-30});
    EXPECT_EQ(d.sample(0.5).index, 1U);
    EXPECT_EQ(d.sample(kOneMinusEpsilon).index, 1U);
    // What is too light to be told from its neighbour has no probability at all: pmf and sampler agree on it.
    EXPECT_EQ(d.pmf(2), 0);
}

}  // namespace
}  // namespace etendue::test
