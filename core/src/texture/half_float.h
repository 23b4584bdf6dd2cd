#pragma once

#include <bit>
#include <cstdint>

namespace etendue {

/// The value of an IEEE 754 half float given by its bits. Exact; subnormals count as 0 where the processor flushes
/// them.
[[nodiscard]] inline float half_to_float(std::uint16_t half) {
    constexpr std::uint32_t exponent_mask = 0x7c00U;
    const std::uint32_t sign = (half & 0x8000U) << 16;
    const std::uint32_t magnitude = (half & 0x7fffU) << 13;  // the mantissas are 10 and 23 bits wide
    if ((half & exponent_mask) == exponent_mask) return std::bit_cast<float>(sign | 0x7f800000U | magnitude);
    // The exponents are biased by 15 and 127.
    return std::bit_cast<float>(sign | std::bit_cast<std::uint32_t>(std::bit_cast<float>(magnitude) * 0x1p112F));
}

}  // namespace etendue
