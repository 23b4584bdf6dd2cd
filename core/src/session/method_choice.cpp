#include "session/method_choice.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace etendue {
namespace {

/// Between numbers of light paths that are tried. Where light paths cost as much as camera paths together and noise
/// comes as much from either, a factor of two costs an eighth.
constexpr double kStep = 4;
constexpr double kStart = 1;
constexpr double kMostTried = 16;
/// Doublings from 4 on that the curve has to ask for to go beyond: curves flatten there.
constexpr double kBeyond = 2.75;
/// Path has to be cheaper than bdpt by so much: what makes it slow is hard to see in a short trial.
constexpr double kMargin = 0.9;

ChosenMethod bdpt(double light_paths) { return {IntegratorKind::Bdpt, light_paths}; }

/// Of those that are tried.
double best_tried(const MethodCost& cost) {
    double n = kStart;
    while (n < kMostTried && cost(bdpt(n * kStep)) < cost(bdpt(n))) n *= kStep;
    if (n > kStart) return n;
    while (n > kFewestLightPaths && cost(bdpt(n / kStep)) < cost(bdpt(n))) n /= kStep;
    return n;
}

/// Where the parabola through (-1, below), (0, here) and (1, above) is least.
std::optional<double> least_place(double below, double here, double above) {
    const double curvature = below - 2 * here + above;
    if (!(curvature > 0) || !std::isfinite(curvature)) return {};
    return (below - above) / (2 * curvature);
}

/// The power of two that is least on the curve through the best and its neighbours, with logarithms for both: also of
/// those that were not tried, and less by the luck of a single trial.
double best_on_curve(double best, const MethodCost& cost) {
    const double centre = std::clamp(best, kFewestLightPaths * kStep, kMostTried / kStep);
    const auto log_cost = [&](double n) { return std::log(cost(bdpt(n))); };
    const auto place = least_place(log_cost(centre / kStep), log_cost(centre), log_cost(centre * kStep));
    if (!place) return best;
    const double doublings = std::log2(kStep) * *place;
    const double most = doublings < kBeyond ? kMostTried : kMostLightPaths;
    return std::clamp(centre * std::exp2(std::round(doublings)), kFewestLightPaths, most);
}

}  // namespace

ChosenMethod choose_method(const MethodCost& cost, double most) {
    const double tried = best_tried(cost);
    const ChosenMethod path{IntegratorKind::Path, {}};
    if (cost(path) < kMargin * cost(bdpt(tried))) return path;
    return bdpt(std::min(best_on_curve(tried, cost), most));
}

}  // namespace etendue
