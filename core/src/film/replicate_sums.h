#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "film/replicates.h"
#include "math/rgb.h"

namespace etendue {

/// What a pixel keeps for its variance: the present pass, and the sum over the passes of each replicate.
struct ReplicateSums {
    Rgb camera;
    Rgb splat;
    std::array<Rgb, kReplicates> passes;
};

/// How the complete passes are shared out.
struct ReplicateCounts {
    explicit ReplicateCounts(std::uint64_t passes)
        : total(static_cast<double>(passes)), replicates(std::min(passes, kReplicates)) {
        for (std::uint64_t r = 0; r < kReplicates; ++r) of[r] = static_cast<double>(passes_of_replicate(r, passes));
    }

    double total;
    std::uint64_t replicates;              ///< those that have any
    std::array<double, kReplicates> of{};  ///< passes of each
};

/// Mean over all complete passes.
inline Rgb mean_of(const ReplicateSums& sums, const ReplicateCounts& counts) {
    Rgb mean;
    for (const Rgb& sum : sums.passes) mean += sum / counts.total;
    return mean;
}

/// What replicate `r` adds to the variance of that mean. Needs two replicates, and a pass of this one.
inline Rgb variance_by(std::uint64_t r, const ReplicateSums& sums, const Rgb& mean, const ReplicateCounts& counts) {
    const Rgb off = sums.passes[r] / counts.of[r] - mean;
    return off * off * (counts.of[r] / (static_cast<double>(counts.replicates - 1) * counts.total));
}

}  // namespace etendue
