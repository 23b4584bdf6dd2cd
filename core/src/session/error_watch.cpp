#include "session/error_watch.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

constexpr double kStandardErrors = 2;
constexpr double kLeastGrowth = 1.1;
constexpr double kMostGrowth = 2;

/// Replicates of equal length compare best.
std::int64_t whole_rounds(double passes) {
    const auto round = static_cast<double>(kReplicates);
    return static_cast<std::int64_t>(std::ceil(passes / round) * round);
}

}  // namespace

void ErrorWatch::look(std::int64_t passes, const ErrorEstimate& estimate) {
    looked_at_ = passes;
    error_ = std::sqrt(estimate.value);
    // relMSE falls like 1 / passes, or faster where samples are stratified.
    const double over = std::sqrt(estimate.value + kStandardErrors * estimate.standard_error) / target_;
    const double growth = over * over;
    growth_ = target_ > 0 && std::isfinite(growth) ? growth : std::numeric_limits<double>::infinity();
    next_look_ = whole_rounds(static_cast<double>(passes) * std::clamp(growth_, kLeastGrowth, kMostGrowth));
}

double ErrorWatch::fraction(std::int64_t passes) const {
    if (reached()) return 1;
    if (looked_at_ == 0) return 0;
    return std::min(1.0, static_cast<double>(passes) / (static_cast<double>(looked_at_) * growth_));
}

}  // namespace etendue
