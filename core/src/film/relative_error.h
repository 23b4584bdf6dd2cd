#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "film/replicate_sums.h"

namespace etendue {

/// Estimate of a picture's squared relative error, relMSE as RenderStatistics::error has it.
struct ErrorEstimate {
    double value = 0;
    /// As if all of a pixel's term were chance, which a firefly's is: 1 / sqrt(n) of an estimate that rests on n
    /// pixels. What has not been seen is not in it.
    double standard_error = 0;
};

/// Sums over pixels; parts of a picture may be summed by different threads and added up.
class ErrorSums {
public:
    void add(double term) {
        ++count_;
        sum_ += term;
        squares_ += term * term;
    }
    ErrorSums& operator+=(const ErrorSums& other);

    /// `sharing`: how many pixels have their noise in common. A splat falls on all that its filter reaches.
    [[nodiscard]] ErrorEstimate estimate(double sharing) const;

private:
    double count_ = 0;
    double sum_ = 0;
    double squares_ = 0;
};

/// relMSE of a picture against what it converges to, estimated from the picture alone.
///
/// A pixel adds v / (m^2 + (0.02 M)^2). The variance v of the mean is seen in the replicates, without bias. The pixel's
/// true value m is not known, and the value v was seen around would mislead: where it came out bright by luck it is
/// both noisy and bright, and the quotient small; a firefly would be divided by itself. So the deviations of two
/// replicates at a time are divided by what the six others make of the pixel, which knows no more of their luck than
/// the mean of all eight brings in, from which deviations are taken: a covariance of -1/8 of a replicate's variance.
/// Six see less than eight, and 1 / m^2 of a noisy m is too large on average: m is therefore smoothed over its eight
/// neighbours by as much as their differences are noise (Wiener's filter, as Lee 1980 takes it to pictures).
class RelativeError {
public:
    /// Needs a complete pass of every replicate.
    RelativeError(const ReplicateSums& sums, int width);

    [[nodiscard]] int height() const { return height_; }
    /// Of rows [begin, end).
    [[nodiscard]] ErrorSums of_rows(int begin, int end) const;

private:
    /// Replicates whose deviations are divided by what the others say.
    static constexpr std::uint64_t kTogether = 2;
    static constexpr std::uint64_t kGroups = kReplicates / kTogether;

    /// One pixel, means over channels; a value for each group.
    struct View {
        std::array<double, kGroups> deviation{};  ///< the group's share of the variance
        std::array<double, kGroups> mean{};       ///< by the other replicates
        std::array<double, kGroups> noise{};      ///< variance of that mean
    };
    class Rows;

    [[nodiscard]] View look(std::size_t pixel) const;

    const ReplicateSums& sums_;
    int width_;
    int height_;
    std::array<double, kReplicates> passes_{};    ///< of each
    std::array<double, kReplicates> per_pass_{};  ///< one over it
    double darkest_squared_ = 0;
};

}  // namespace etendue
