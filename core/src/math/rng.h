#pragma once

#include <cstdint>

#include "math/vec.h"

namespace etendue {

/// Independent uniform numbers: SplitMix64 (Steele, Lea and Flood 2014), which starts at once, as short paths want it.
/// The key alone decides the stream: no thread ever matters.
class Rng {
public:
    Rng(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) : key_(mix(mix(mix(seed) ^ stream) ^ index)) {}

    /// In [0, 1), 53 bits.
    double next_1d() { return static_cast<double>(next_bits() >> 11) * 0x1p-53; }
    Vec2 next_2d() {
        const double x = next_1d();
        return {x, next_1d()};
    }
    std::uint64_t next_bits() { return mix(key_ += kGolden); }
    /// A stream of its own for each index; this one does not move.
    [[nodiscard]] Rng fork(std::uint64_t index) const { return Rng(mix(key_ ^ mix(index))); }

private:
    static constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;

    explicit Rng(std::uint64_t key) : key_(key) {}

    static std::uint64_t mix(std::uint64_t z) {
        z += kGolden;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }

    std::uint64_t key_;
};

}  // namespace etendue
