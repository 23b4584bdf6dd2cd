#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "film/replicate_sums.h"

namespace etendue {

/// Estimate of a picture's squared relative error, relMSE as RenderStatistics::error has it.
struct ErrorEstimate {
    double value = 0;
    double standard_error = 0;  ///< as far as what was seen can tell
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
/// replicates at a time are divided by what the six others make of the pixel, which knows nothing of their luck. Six
/// see less than eight, and 1 / m^2 of a noisy m is too large on average: m is therefore smoothed over its eight
/// neighbours by as much as their differences are noise (Wiener's filter, as Lee 1980 takes it to pictures).
class RelativeError {
public:
    /// Of the pixels' sums row by row, after so many complete passes: one of every replicate at least.
    RelativeError(std::span<const ReplicateSums> pixels, int width, std::uint64_t passes);

    [[nodiscard]] int height() const { return height_; }
    /// Of rows [begin, end).
    [[nodiscard]] ErrorSums of_rows(int begin, int end) const;

private:
    /// Replicates whose deviations are divided by what the others say.
    static constexpr std::uint64_t kTogether = 2;
    static constexpr std::uint64_t kGroups = kReplicates / kTogether;

    /// Means over channels, of one pixel and for one group.
    struct View {
        double deviation = 0;  ///< the group's share of the variance
        double mean = 0;       ///< by the other replicates
        double noise = 0;      ///< variance of that mean
    };
    using Views = std::array<View, kGroups>;

    [[nodiscard]] Views look(const ReplicateSums& sums) const;
    [[nodiscard]] double smoothed(const std::vector<Views>& rows, int height, int x, int y, std::uint64_t group) const;

    std::span<const ReplicateSums> pixels_;
    int width_;
    int height_;
    ReplicateCounts counts_;
    double darkest_squared_ = 0;
};

}  // namespace etendue
