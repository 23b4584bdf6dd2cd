#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include <etendue/render_settings.h>

namespace etendue {

/// Passes of a block spread their samples evenly over it; blocks are independent, which is what an honest variance is
/// made of. So there are at least kBlocks of them, and the more samples there are the longer they get.
inline std::uint64_t passes_per_block(const RenderSettings& settings) {
    constexpr std::uint64_t kBlocks = 8;
    constexpr std::uint64_t kLongest = 64;
    constexpr std::uint64_t kOpenEnded = 16;  // renders that only time ends
    if (settings.samples_per_pixel == 0) return kOpenEnded;
    const auto passes = static_cast<std::uint64_t>(settings.samples_per_pixel);
    return std::min(std::bit_floor(std::max(passes / kBlocks, std::uint64_t{1})), kLongest);
}

}  // namespace etendue
