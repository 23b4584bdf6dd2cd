#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <etendue/render_settings.h>

#include "film/filter.h"

namespace etendue {

/// Number of a pixel within the window, row by row.
inline std::size_t pixel_index(const PixelWindow& window, int x, int y) {
    return static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.x1 - window.x0) +
           static_cast<std::size_t>(x - window.x0);
}

/// Calls add(pixel index, filter's density) for every pixel of the window that gathers light at `raster`.
template <typename Add>
void spread_splat(const Filter& filter, const PixelWindow& window, const Vec2& raster, const Add& add) {
    // Pixel (x, y) has its centre at (x + 0.5, y + 0.5).
    const double r = filter.radius();
    const int x0 = std::max(window.x0, static_cast<int>(std::ceil(raster.x - r - 0.5)));
    const int x1 = std::min(window.x1 - 1, static_cast<int>(std::floor(raster.x + r - 0.5)));
    const int y0 = std::max(window.y0, static_cast<int>(std::ceil(raster.y - r - 0.5)));
    const int y1 = std::min(window.y1 - 1, static_cast<int>(std::floor(raster.y + r - 0.5)));
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const double weight = filter.eval({raster.x - x - 0.5, raster.y - y - 0.5});
            if (weight > 0) add(pixel_index(window, x, y), weight);
        }
    }
}

}  // namespace etendue
