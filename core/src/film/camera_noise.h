#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <etendue/render_settings.h>

#include "film/replicate_sums.h"

namespace etendue {

/// Mean over a tile's pixels of v / (m^2 + (0.02 M)^2): the variance v of one pass, relative as relMSE has it.
struct TileNoise {
    double camera = 0;
    double splats = 0;
};

/// How noisy passes are for a picture whose error is relative (RenderStatistics::error), as one half of the
/// replicates has seen it. The noise of splats is kept apart: more camera samples would not lessen it.
class CameraNoise {
public:
    /// Needs uneven sums with complete passes of every replicate, one sample a pixel each, of the pixels of `window`.
    CameraNoise(const ReplicateSums& sums, const PixelWindow& window, std::uint64_t half);

    /// Pixels are as bright as they look where their differences stand out of the noise, and as the tile's mean as far
    /// as they do not: a firefly is not measured by itself.
    [[nodiscard]] TileNoise of(const PixelWindow& tile) const;

private:
    static constexpr std::uint64_t kMembers = kReplicates / kHalves;

    /// One pixel, means over channels.
    struct View {
        double camera = 0;  ///< variance of one pass
        double splats = 0;  ///< likewise
        double mean = 0;    ///< of all passes of the half
        double noise = 0;   ///< variance of that mean
    };
    [[nodiscard]] View look(std::size_t pixel) const;

    const ReplicateSums& sums_;
    PixelWindow window_;
    std::array<std::uint64_t, kMembers> members_{};
    double darkest_squared_ = 0;
};

}  // namespace etendue
