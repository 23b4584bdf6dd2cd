#pragma once

#include <cstdint>

namespace etendue {

/// Passes are dealt to so many replicates in turn. The samples of one are spread evenly over its passes; replicates are
/// independent of each other, which is what an honest variance is made of. The length of the render has no part in it:
/// one that is stopped is the beginning of a longer one.
inline constexpr std::uint64_t kReplicates = 8;

struct PassPlace {
    std::uint64_t replicate = 0;
    std::uint64_t index = 0;  ///< among the passes of the replicate
};

inline PassPlace place_of_pass(std::uint64_t pass) { return {pass % kReplicates, pass / kReplicates}; }

/// How many of the first `passes` passes are the replicate's.
inline std::uint64_t passes_of_replicate(std::uint64_t replicate, std::uint64_t passes) {
    return (passes + kReplicates - 1 - replicate) / kReplicates;
}

/// Where samples go where the noise is (RenderSettings::adaptive), the replicates form two halves, each of which is
/// told by the other one how many samples to take (session/sample_plan.h).
inline constexpr std::uint64_t kHalves = 2;

inline std::uint64_t half_of_replicate(std::uint64_t replicate) { return replicate % kHalves; }

/// The first passes of each replicate have one sample a pixel, wherever later ones go.
inline constexpr std::uint64_t kEvenRounds = 2;

}  // namespace etendue
