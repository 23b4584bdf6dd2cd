#include "math/rng.h"

#include <set>

#include <gtest/gtest.h>

#include "support/chi2.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

TEST(Rng, RepeatsItself) {
    Rng a(1, 2, 3);
    Rng b(1, 2, 3);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(a.next_1d(), b.next_1d());
}

TEST(Rng, NeighbouringKeysShareNothing) {
    std::set<double> seen;
    std::size_t drawn = 0;
    for (std::uint64_t seed = 0; seed < 16; ++seed) {
        for (std::uint64_t stream = 0; stream < 16; ++stream) {
            for (std::uint64_t index = 0; index < 16; ++index) {
                Rng rng(seed, stream, index);
                for (int i = 0; i < 4; ++i, ++drawn) seen.insert(rng.next_1d());
            }
        }
    }
    // 16384 numbers of 53 bits: two are equal by chance once in 10^8 tries.
    EXPECT_EQ(seen.size(), drawn);
}

TEST(Rng, HasUniformMoments) {
    const int n = samples(400000);
    std::array<Estimate, 4> moments;
    Estimate serial;
    Rng rng(7, 0, 0);
    double before = rng.next_1d();
    for (int i = 0; i < n; ++i) {
        const double x = rng.next_1d();
        ASSERT_GE(x, 0);
        ASSERT_LT(x, 1);
        double power = 1;
        for (Estimate& moment : moments) moment.add(power *= x);
        serial.add(x * before);
        before = x;
    }
    for (std::size_t k = 0; k < moments.size(); ++k)
        EXPECT_TRUE(agrees(moments[k], 1.0 / (static_cast<double>(k) + 2)));
    EXPECT_TRUE(agrees(serial, 0.25));
}

// The first numbers of neighbouring streams are what a picture is made of.
TEST(Rng, IsUniformAcrossStreams) {
    std::uint64_t pixel = 0;
    const PlaneSampler first_pair = [&pixel](Rng&) {
        Rng own(0, 0, pixel++);
        return own.next_2d();
    };
    const PlaneDensity one = [](const Vec2&) { return 1.0; };
    EXPECT_TRUE(passes(chi2_square(first_pair, one, {})));

    std::uint64_t key = 0;
    const PlaneSampler across = [&key](Rng&) {
        const double x = Rng(key, 0, 5).next_1d();
        const double y = Rng(++key, 0, 5).next_1d();
        return Vec2{x, y};
    };
    EXPECT_TRUE(passes(chi2_square(across, one, {})));
}

}  // namespace
}  // namespace etendue::test
