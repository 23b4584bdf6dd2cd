#pragma once

#include <cstdint>

#include "film/replicates.h"
#include "math/sampler.h"

namespace etendue {

/// The numbers of each camera sample and each light path, whoever traces it. In a replicate a pixel's samples are one
/// sequence, and so are all light paths.
class RandomStreams {
public:
    RandomStreams(std::uint64_t seed, std::uint64_t light_paths_per_pass)
        : seed_(seed), light_paths_per_pass_(light_paths_per_pass) {}

    /// `sample`: its number among those that the pass's replicate takes of the pixel.
    [[nodiscard]] Sampler camera(std::uint64_t pass, std::uint64_t pixel, std::uint64_t sample) const {
        return at_pixel(Use::Camera, pass, pixel, sample);
    }
    /// For what is joined to a camera path once it stands: it shares no draws with the path itself.
    [[nodiscard]] Sampler joins(std::uint64_t pass, std::uint64_t pixel, std::uint64_t sample) const {
        return at_pixel(Use::Joins, pass, pixel, sample);
    }
    [[nodiscard]] Sampler light(std::uint64_t pass, std::uint64_t path) const {
        const PassPlace place = place_of_pass(pass);
        const std::uint64_t index = place.index * light_paths_per_pass_ + path;
        return Sampler({seed_, stream(Use::Light, place), index >> 32, index & 0xffffffff});
    }

private:
    enum class Use : std::uint64_t { Camera, Joins, Light };
    static constexpr std::uint64_t kUses = 3;

    static std::uint64_t stream(Use use, const PassPlace& place) {
        return place.replicate * kUses + static_cast<std::uint64_t>(use);
    }
    [[nodiscard]] Sampler at_pixel(Use use, std::uint64_t pass, std::uint64_t pixel, std::uint64_t sample) const {
        return Sampler({seed_, stream(use, place_of_pass(pass)), pixel, sample});
    }

    std::uint64_t seed_;
    std::uint64_t light_paths_per_pass_;
};

}  // namespace etendue
