#pragma once

#include <cmath>

namespace etendue {

/// IEC 61966-2-1: linear value of an encoded one. Negative values lie on the linear segment, those above 1 on the
/// curve.
[[nodiscard]] inline double srgb_to_linear(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace etendue
