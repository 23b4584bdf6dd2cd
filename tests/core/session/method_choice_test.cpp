// The search for the cheapest method, held against costs made up.

#include "session/method_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace etendue::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Work c + n times noise 1 + b / n, least at n = sqrt(b c); that of path by itself.
struct MadeUp {
    double b = 1;
    double c = 1;
    double path = kInfinity;

    double operator()(const ChosenMethod& method) const {
        if (method.integrator == IntegratorKind::Path) return path;
        const double n = method.light_paths_per_pixel.value_or(0);
        return (c + n) * (1 + b / n);
    }
    [[nodiscard]] double least() const {
        double cost = kInfinity;
        for (int doublings = 0; doublings <= std::log2(kMostLightPaths / kFewestLightPaths); ++doublings) {
            cost = std::min(cost, (*this)({IntegratorKind::Bdpt, kFewestLightPaths * std::exp2(doublings)}));
        }
        return cost;
    }
};

TEST(MethodChoice, FindsTheBestNumberOfLightPaths) {
    for (int step = -20; step <= 28; ++step) {
        const double best = std::exp2(0.25 * step);
        for (const double c : {0.1, 1.0, 10.0, 1000.0}) {
            const MadeUp costs{best * best / c, c, kInfinity};
            const ChosenMethod chosen = choose_method(costs);
            EXPECT_EQ(chosen.integrator, IntegratorKind::Bdpt);
            const double n = chosen.light_paths_per_pixel.value_or(0);
            EXPECT_EQ(n, std::exp2(std::round(std::log2(n))));
            EXPECT_GE(n, kFewestLightPaths);
            EXPECT_LE(n, kMostLightPaths);
            EXPECT_LE(costs(chosen), 1.08 * costs.least()) << best << " " << c;
        }
    }
}

TEST(MethodChoice, TakesPathWhereItIsClearlyCheaper) {
    MadeUp costs;
    costs.path = 0.85 * costs.least();
    EXPECT_EQ(choose_method(costs).integrator, IntegratorKind::Path);
    costs.path = 0.95 * costs.least();
    EXPECT_EQ(choose_method(costs).integrator, IntegratorKind::Bdpt);
    costs.path = kInfinity;
    EXPECT_EQ(choose_method(costs).integrator, IntegratorKind::Bdpt);
}

// A picture without noise, and one in which nothing was seen.
TEST(MethodChoice, EndsWhateverCostsAre) {
    for (const double cost : {0.0, kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
        const ChosenMethod chosen = choose_method([=](const ChosenMethod&) { return cost; });
        EXPECT_EQ(chosen.integrator, IntegratorKind::Bdpt);
        EXPECT_EQ(chosen.light_paths_per_pixel, 1);
    }
}

}  // namespace
}  // namespace etendue::test
