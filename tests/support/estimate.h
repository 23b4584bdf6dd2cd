#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

namespace etendue::test {

/// Samples to take when `full` are wanted: fewer under ETENDUE_TEST_EFFORT, a fraction (sanitizer runs).
inline int samples(int full) {
    static const double effort = [] {
        const char* text = std::getenv("ETENDUE_TEST_EFFORT");
        return text == nullptr ? 1.0 : std::clamp(std::strtod(text, nullptr), 1e-3, 1.0);
    }();
    return std::max(100, static_cast<int>(full * effort));
}

/// False when a run takes fewer samples than its statistics were laid out for: what looks for errors of memory then
/// still looks, but rare events are too few for a verdict.
inline bool full_effort() { return samples(1000) == 1000; }

/// Mean of independent samples with the standard error they show (Welford).
class Estimate {
public:
    void add(double x) {
        ++count_;
        const double delta = x - mean_;
        mean_ += delta / count_;
        sum_squares_ += delta * (x - mean_);
    }
    [[nodiscard]] double mean() const { return mean_; }
    [[nodiscard]] double standard_error() const { return std::sqrt(sum_squares_ / count_ / std::max(1.0, count_ - 1)); }

private:
    double count_ = 0;
    double mean_ = 0;
    double sum_squares_ = 0;
};

/// Five standard errors: a right estimator fails one check in 1.7 million; 1e-9 relative is left to rounding.
inline constexpr double kSigmas = 5;
inline constexpr double kRounding = 1e-9;

/// The mean is `expected` within kSigmas of its own standard error, which at full effort must be less than
/// `resolution` of it: an estimate too noisy to tell right from wrong is a failure too.
inline testing::AssertionResult agrees(const Estimate& estimate, double expected, double resolution = 0.003) {
    const double error = estimate.standard_error();
    const double off = std::abs(estimate.mean() - expected);
    if (!(off <= kSigmas * error + kRounding * std::abs(expected))) {
        return testing::AssertionFailure()
               << "mean " << estimate.mean() << " +- " << error << ", expected " << expected << ": " << off / error
               << " standard errors, ratio " << estimate.mean() / expected;
    }
    if (full_effort() && error > resolution * std::abs(expected)) {
        return testing::AssertionFailure() << "standard error " << error << " is too large for " << expected;
    }
    return testing::AssertionSuccess();
}

/// Two independent estimates of the same thing.
inline testing::AssertionResult agree(const Estimate& a, const Estimate& b, double resolution = 0.003) {
    const double error = std::hypot(a.standard_error(), b.standard_error());
    const double off = std::abs(a.mean() - b.mean());
    if (!(off <= kSigmas * error + kRounding * std::abs(a.mean()))) {
        return testing::AssertionFailure() << a.mean() << " +- " << a.standard_error() << " and " << b.mean() << " +- "
                                           << b.standard_error() << ": " << off / error << " standard errors";
    }
    if (full_effort() && error > resolution * std::abs(a.mean())) {
        return testing::AssertionFailure() << "standard error " << error << " is too large for " << a.mean();
    }
    return testing::AssertionSuccess();
}

}  // namespace etendue::test
