#pragma once

#include <cstdint>

namespace etendue {

/// The first two dimensions of Sobol's sequence, a (0, 2)-sequence: of any 2^k points from a multiple of 2^k on, each
/// elementary interval of area 2^-k holds exactly one. Scrambled after Owen (1995), which keeps that and makes every
/// point uniform; the scrambling is by hashing (Laine and Karras 2011, Burley 2020, constants of Vegdahl 2021).

inline std::uint32_t reverse_bits(std::uint32_t x) {
    x = __builtin_bswap32(x);
    x = ((x >> 4) & 0x0f0f0f0f) | ((x & 0x0f0f0f0f) << 4);
    x = ((x >> 2) & 0x33333333) | ((x & 0x33333333) << 2);
    return ((x >> 1) & 0x55555555) | ((x & 0x55555555) << 1);
}

/// A permutation in which a bit of the result depends on no higher bit: Owen's scrambling, of numbers whose digits
/// stand in reverse.
inline std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adea;
    x += seed;
    x *= (seed >> 16) | 1;
    x ^= x * 0x05526c56;
    x ^= x * 0x53a22864;
    return x;
}

/// Digits of the second dimension, in reverse: digit j is the sum over k of binomial(k, j) times bit k of the index. By
/// Lucas' theorem the coefficient is odd where the bits of j are among those of k: a sum over supersets, taken one bit
/// of the positions at a time.
inline std::uint32_t second_dimension_reversed(std::uint32_t index) {
    std::uint32_t x = index;
    x ^= (x >> 1) & 0x55555555;
    x ^= (x >> 2) & 0x33333333;
    x ^= (x >> 4) & 0x0f0f0f0f;
    x ^= (x >> 8) & 0x00ff00ff;
    x ^= (x >> 16) & 0x0000ffff;
    return x;
}

}  // namespace etendue
