#pragma once

#include <algorithm>
#include <cmath>

#include <etendue/scene_description.h>

namespace etendue {

/// Stands for "no texel": black.
inline constexpr int kOutside = -1;

/// Brings a coordinate (1 is the image's size) to where its texel indices fit an int, without changing what it means.
[[nodiscard]] inline double reduce_coordinate(TextureWrap wrap, double u) {
    switch (wrap) {
        case TextureWrap::Repeat:
            return u - std::floor(u);
        case TextureWrap::Mirror:
            return u - 2 * std::floor(u / 2);
        case TextureWrap::Clamp:
            return std::clamp(u, 0.0, 1.0);
        case TextureWrap::Black:
        case TextureWrap::UseMetadata:
            break;
    }
    return std::clamp(u, -2.0, 3.0);  // any image has at least one texel: beyond, both neighbours are outside
}

/// The texel that index i means in an image of n texels, for indices of reduced coordinates (one beyond the ends too).
[[nodiscard]] inline int wrap_index(TextureWrap wrap, int i, int n) {
    switch (wrap) {
        case TextureWrap::Repeat:
            return i < 0 ? i + n : (i >= n ? i - n : i);
        case TextureWrap::Mirror: {
            const int j = i < 0 ? -1 - i : i;
            return j < n ? j : std::max(2 * n - 1 - j, j - 2 * n);
        }
        case TextureWrap::Clamp:
            return std::clamp(i, 0, n - 1);
        case TextureWrap::Black:
        case TextureWrap::UseMetadata:
            break;
    }
    return i >= 0 && i < n ? i : kOutside;
}

}  // namespace etendue
