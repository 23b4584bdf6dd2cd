#pragma once

#include <cstdint>

#include "math/rng.h"
#include "math/sobol_pair.h"
#include "math/vec.h"

namespace etendue {

/// Which sequence a path's numbers come from, and which of its points they are. Paths of one sequence are spread
/// evenly; paths of different sequences are independent.
struct SampleIndex {
    std::uint64_t seed = 0;
    std::uint64_t stream = 0;
    std::uint64_t sequence = 0;
    std::uint64_t index = 0;  ///< below 2^32
};

/// The numbers of one path. The first few draws, which decide most, are stratified over the paths of a sequence: each
/// is one point of a scrambled Sobol pair, shuffled on its own so that draws are unrelated. Later draws are
/// independent. Uniform and unbiased for any one path; the key alone decides the numbers.
class Sampler {
public:
    explicit Sampler(const SampleIndex& at)
        : scramble_(at.seed, at.stream, at.sequence),
          independent_(scramble_.fork(at.index)),
          reversed_index_(reverse_bits(static_cast<std::uint32_t>(at.index))) {}

    /// In [0, 1).
    double next_1d() {
        if (draws_ >= kStratified) return independent_.next_1d();
        return to_unit(reverse_bits(scramble_reversed(shuffled_index(), high(scramble_.next_bits()))));
    }
    Vec2 next_2d() {
        if (draws_ >= kStratified) return independent_.next_2d();
        const std::uint32_t index = shuffled_index();
        const std::uint64_t seeds = scramble_.next_bits();
        return {to_unit(reverse_bits(scramble_reversed(index, high(seeds)))),
                to_unit(reverse_bits(scramble_reversed(second_dimension_reversed(index), low(seeds))))};
    }

private:
    /// Beyond, evenness is lost in the noise of what came before, and independent numbers cost less.
    static constexpr int kStratified = 10;

    /// The middle of one of 2^32 intervals. Its lower end could be 0, where a cosine and its density vanish.
    static double to_unit(std::uint32_t x) { return (x + 0.5) * 0x1p-32; }
    static std::uint32_t high(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }
    static std::uint32_t low(std::uint64_t x) { return static_cast<std::uint32_t>(x); }

    std::uint32_t shuffled_index() {
        ++draws_;
        return reverse_bits(scramble_reversed(reversed_index_, high(scramble_.next_bits())));
    }

    Rng scramble_;     ///< the same for all paths of the sequence
    Rng independent_;  ///< this path's own
    std::uint32_t reversed_index_;
    int draws_ = 0;
};

}  // namespace etendue
