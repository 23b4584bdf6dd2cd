#pragma once

#include <cstdint>

#include "math/rng.h"

namespace etendue {

/// One stream of random numbers for each camera sample and each light path, whoever traces it.
inline Rng camera_stream(std::uint64_t seed, std::uint64_t pass, std::uint64_t pixel) {
    return {seed, 2 * pass, pixel};
}
inline Rng light_stream(std::uint64_t seed, std::uint64_t pass, std::uint64_t path) {
    return {seed, 2 * pass + 1, path};
}

}  // namespace etendue
