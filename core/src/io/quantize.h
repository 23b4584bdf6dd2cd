#pragma once

#include <limits>

namespace etendue {

/// The nearest code of an unsigned integer for a value in [0, 1]; outside it the nearer end, for NaN 0.
template <typename T>
[[nodiscard]] T quantize(float value) {
    constexpr T top = std::numeric_limits<T>::max();
    if (!(value > 0)) return 0;
    if (value >= 1) return top;
    return static_cast<T>(static_cast<double>(value) * top + 0.5);
}

}  // namespace etendue
