#pragma once

#include <cstdint>

#include "film/pass_blocks.h"
#include "math/sampler.h"

namespace etendue {

/// The numbers of each camera sample and each light path, whoever traces it. In a block of passes a pixel's samples are
/// one sequence, and so are all light paths of the block.
class RandomStreams {
public:
    RandomStreams(const RenderSettings& settings, std::uint64_t light_paths_per_pass)
        : seed_(settings.seed),
          passes_per_block_(passes_per_block(settings)),
          light_paths_per_pass_(light_paths_per_pass) {}

    [[nodiscard]] Sampler camera(std::uint64_t pass, std::uint64_t pixel) const {
        return at_pixel(Use::Camera, pass, pixel);
    }
    /// For what is joined to a camera path once it stands: it shares no draws with the path itself.
    [[nodiscard]] Sampler joins(std::uint64_t pass, std::uint64_t pixel) const {
        return at_pixel(Use::Joins, pass, pixel);
    }
    [[nodiscard]] Sampler light(std::uint64_t pass, std::uint64_t path) const {
        const std::uint64_t index = pass % passes_per_block_ * light_paths_per_pass_ + path;
        return Sampler({seed_, stream(Use::Light, pass), index >> 32, index & 0xffffffff});
    }

private:
    enum class Use : std::uint64_t { Camera, Joins, Light };
    static constexpr std::uint64_t kUses = 3;

    [[nodiscard]] std::uint64_t stream(Use use, std::uint64_t pass) const {
        return pass / passes_per_block_ * kUses + static_cast<std::uint64_t>(use);
    }
    [[nodiscard]] Sampler at_pixel(Use use, std::uint64_t pass, std::uint64_t pixel) const {
        return Sampler({seed_, stream(use, pass), pixel, pass % passes_per_block_});
    }

    std::uint64_t seed_;
    std::uint64_t passes_per_block_;
    std::uint64_t light_paths_per_pass_;
};

}  // namespace etendue
