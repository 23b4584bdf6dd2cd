#include "math/sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "support/chi2.h"

namespace etendue::test {
namespace {

Sampler at(std::uint64_t sequence, std::uint64_t index) { return Sampler({3, 1, sequence, index}); }

const PlaneDensity kOne = [](const Vec2&) { return 1.0; };
const Chi2Settings kSettings{.samples = 50000};

/// Draw number `draw` of the first `count` paths of a sequence, or of `count` from `first` on.
std::vector<Vec2> points(std::uint64_t sequence, std::uint64_t first, std::uint64_t count, int draw) {
    std::vector<Vec2> out;
    for (std::uint64_t i = first; i < first + count; ++i) {
        Sampler sampler = at(sequence, i);
        for (int d = 0; d < draw; ++d) sampler.next_2d();
        out.push_back(sampler.next_2d());
    }
    return out;
}

/// Whether each of the 2^a x 2^b boxes holds one point.
bool one_in_each_box(const std::vector<Vec2>& points, int a, int b) {
    std::set<std::pair<int, int>> boxes;
    for (const Vec2& p : points) {
        boxes.emplace(static_cast<int>(std::ldexp(p.x, a)), static_cast<int>(std::ldexp(p.y, b)));
    }
    return boxes.size() == points.size();
}

TEST(Sampler, PairsAreANet) {
    for (std::uint64_t sequence = 0; sequence < 20; ++sequence) {
        for (int draw = 0; draw < 4; ++draw) {
            for (int k = 0; k <= 10; ++k) {
                const std::uint64_t count = std::uint64_t{1} << k;
                for (std::uint64_t block : {0U, 1U, 5U}) {
                    const std::vector<Vec2> net = points(sequence, block * count, count, draw);
                    for (int a = 0; a <= k; ++a) ASSERT_TRUE(one_in_each_box(net, a, k - a)) << k << ' ' << a;
                }
            }
        }
    }
}

TEST(Sampler, SingleNumbersAreStratified) {
    for (std::uint64_t sequence = 0; sequence < 20; ++sequence) {
        std::set<int> strata;
        for (std::uint64_t i = 0; i < 256; ++i) {
            Sampler sampler = at(sequence, i);
            sampler.next_2d();
            strata.insert(static_cast<int>(256 * sampler.next_1d()));
        }
        ASSERT_EQ(strata.size(), 256U);
    }
}

/// Stratified draws are odd multiples of 2^-33, hence neither 0 nor 1.
TEST(Sampler, StratifiedDrawsAreNeverZero) {
    const auto odd = [](double x) { return std::fmod(std::ldexp(x, 33), 2) == 1; };
    for (std::uint64_t index = 0; index < 100; ++index) {
        Sampler sampler = at(1, index);
        for (int draw = 0; draw < 10; draw += 2) {
            ASSERT_TRUE(odd(sampler.next_1d())) << draw;
            const Vec2 u = sampler.next_2d();
            ASSERT_TRUE(odd(u.x) && odd(u.y)) << draw;
        }
    }
}

TEST(Sampler, AnyOnePathIsUniform) {
    for (std::uint64_t index : {0U, 1U, 6U, 1000U}) {
        for (int draw : {0, 3, 9, 10, 15}) {
            std::uint64_t sequence = 0;
            const PlaneSampler sample = [&](Rng&) { return points(sequence++, index, 1, draw).front(); };
            EXPECT_TRUE(passes(chi2_square(sample, kOne, kSettings))) << index << ' ' << draw;
        }
    }
}

/// Two draws of the paths of one sequence have nothing to do with each other.
TEST(Sampler, DrawsAreUnrelated) {
    for (int draw = 0; draw < 12; ++draw) {
        std::uint64_t index = 0;
        const PlaneSampler sample = [&](Rng&) {
            Sampler sampler = at(7 + index / 8, index % 8);
            ++index;
            for (int d = 0; d < draw; ++d) sampler.next_2d();
            const double x = sampler.next_2d().x;
            return Vec2{x, sampler.next_2d().x};
        };
        EXPECT_TRUE(passes(chi2_square(sample, kOne, kSettings))) << draw;
    }
}

TEST(Sampler, PathsOfOtherSequencesAreUnrelated) {
    std::uint64_t sequence = 0;
    const PlaneSampler sample = [&](Rng&) {
        const double x = at(sequence, 5).next_1d();
        const double y = at(++sequence, 5).next_1d();
        return Vec2{x, y};
    };
    EXPECT_TRUE(passes(chi2_square(sample, kOne, kSettings)));
}

}  // namespace
}  // namespace etendue::test
