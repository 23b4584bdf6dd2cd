#pragma once

#include <array>
#include <cstdint>

#include "math/vec.h"

namespace etendue {

/// Independent uniform numbers; xoshiro256++ (Blackman and Vigna 2019) seeded through SplitMix64, so that streams with
/// neighbouring keys are unrelated. The key alone decides the stream: no thread ever matters.
class Rng {
public:
    Rng(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
        std::uint64_t key = mix(mix(mix(seed) ^ stream) ^ index);
        for (std::uint64_t& word : state_) word = mix(key += kGolden);
    }

    /// In [0, 1), 53 bits.
    double next_1d() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    Vec2 next_2d() {
        const double x = next_1d();
        return {x, next_1d()};
    }

private:
    static constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;

    static std::uint64_t mix(std::uint64_t z) {
        z += kGolden;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    static std::uint64_t rotate_left(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

    std::uint64_t next() {
        const std::uint64_t result = rotate_left(state_[0] + state_[3], 23) + state_[0];
        const std::uint64_t t = state_[1] << 17;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= t;
        state_[3] = rotate_left(state_[3], 45);
        return result;
    }

    std::array<std::uint64_t, 4> state_{};
};

}  // namespace etendue
