#include "session/error_watch.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace etendue::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Passes at which a render looks whose relMSE is `at_one` after one pass, and its fraction then; up to `most` passes.
struct Course {
    std::vector<std::int64_t> looks;
    std::vector<double> fractions;
};

Course course(ErrorWatch& watch, double at_one, double standard_error, std::int64_t most) {
    Course c;
    for (std::int64_t pass = 1; pass <= most && !watch.reached(); ++pass) {
        if (watch.due(pass)) {
            const double error = at_one / static_cast<double>(pass);
            watch.look(pass, {error, standard_error * error});
            c.looks.push_back(pass);
        }
        c.fractions.push_back(watch.fraction(pass));
    }
    return c;
}

TEST(ErrorWatch, KnowsNothingBeforeItsFirstLook) {
    const ErrorWatch watch(0.1);
    EXPECT_EQ(watch.error(), kInfinity);
    EXPECT_EQ(watch.fraction(15), 0);
    EXPECT_FALSE(watch.reached());
    EXPECT_FALSE(watch.due(15));
    EXPECT_TRUE(watch.due(16));
}

// 100 / n is 0.1^2 at n = 10,000.
TEST(ErrorWatch, LooksSeldomAndEndsSoonAfterTheTarget) {
    ErrorWatch watch(0.1);
    const Course c = course(watch, 100, 0, 100'000);
    EXPECT_EQ(c.looks, (std::vector<std::int64_t>{16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 10'000}));
    EXPECT_DOUBLE_EQ(watch.error(), 0.1);
}

TEST(ErrorWatch, NeverLooksTwiceWithinATenth) {
    ErrorWatch watch(0.1);
    watch.look(1000, {0.0100001, 0});
    EXPECT_FALSE(watch.reached());
    EXPECT_FALSE(watch.due(1103));
    EXPECT_TRUE(watch.due(1104));
}

// 100 (1 + 2 / 4) / n
TEST(ErrorWatch, WantsMoreOfAnUncertainEstimate) {
    ErrorWatch watch(0.1);
    const Course c = course(watch, 100, 0.25, 100'000);
    EXPECT_EQ(c.looks.back(), 15'000);
    EXPECT_LT(watch.error(), 0.1);
}

TEST(ErrorWatch, TellsHowFarItIs) {
    ErrorWatch watch(0.1);
    const Course c = course(watch, 100, 0, 100'000);
    for (std::size_t i = 15; i < c.fractions.size(); ++i) {
        ASSERT_NEAR(c.fractions[i], static_cast<double>(i + 1) / 10'000, 1e-12) << i;
    }
    EXPECT_EQ(c.fractions.back(), 1);
}

TEST(ErrorWatch, TellsTheErrorOfRendersWithoutTarget) {
    ErrorWatch watch(0);
    const Course c = course(watch, 100, 0, 100);
    EXPECT_EQ(c.looks, (std::vector<std::int64_t>{16, 32, 64}));
    EXPECT_EQ(c.fractions.back(), 0);
    EXPECT_DOUBLE_EQ(watch.error(), 1.25);
    watch.look(128, {0, 0});
    EXPECT_FALSE(watch.reached());
}

// Its square is no double.
TEST(ErrorWatch, KnowsATinyTargetFromNone) {
    ErrorWatch watch(1e-200);
    watch.look(16, {1e-300, 0});
    EXPECT_FALSE(watch.reached());
    watch.look(32, {0, 0});
    EXPECT_TRUE(watch.reached());
}

TEST(ErrorWatch, WaitsWhereSumsOverflow) {
    ErrorWatch watch(0.1);
    for (double nonsense : {kInfinity, std::nan("")}) {
        watch.look(16, {nonsense, 0});
        EXPECT_FALSE(watch.reached());
        EXPECT_EQ(watch.fraction(16), 0);
        EXPECT_TRUE(watch.due(32));
        EXPECT_FALSE(watch.due(31));
    }
}

}  // namespace
}  // namespace etendue::test
