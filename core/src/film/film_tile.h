#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <etendue/film_view.h>

#include "math/rgb.h"
#include "math/vec.h"

namespace etendue {

/// One camera sample of a pixel. All but the radiance describe the first surface met.
struct PixelSample {
    Rgb radiance;
    bool hit = false;
    double depth = 0;
    Vec3 normal;
    Rgb albedo;
};

/// What a light path gives to the image at continuous pixel coordinates; divided by the number of light paths later.
struct Splat {
    Vec2 raster;
    Rgb value;
};

/// What a strategy gives to the image, kept beside the picture itself when strategies' images are asked for.
struct StrategySample {
    std::size_t plane = 0;   ///< index into the film's strategies
    std::size_t sample = 0;  ///< of the tile, for camera samples
    Vec2 raster;             ///< for splats
    Rgb value;               ///< unweighted
    double weight = 0;
};

/// What one work unit hands to the film.
struct FilmTile {
    PixelWindow window;                ///< in full-image pixels
    std::size_t number = 0;            ///< among the tiles of a pass
    std::vector<PixelSample> samples;  ///< row by row; then the second ones of all pixels, and so on
    std::vector<Splat> splats;
    std::vector<StrategySample> strategies;  ///< empty unless asked for
    std::uint64_t camera_paths = 0;
    std::uint64_t light_paths = 0;
    std::uint64_t rays = 0;
    std::uint64_t camera_rays = 0;  ///< those of them that camera samples took
    std::array<std::uint64_t, kInvalidKinds> invalid{};

    /// Empties it and keeps the memory.
    void reset(const PixelWindow& tile_window) {
        window = tile_window;
        samples.clear();
        splats.clear();
        strategies.clear();
        camera_paths = light_paths = rays = camera_rays = 0;
        invalid = {};
    }

    /// False, and counted by kind, when the contribution must not reach the film.
    bool accept(const Rgb& c) {
        if (c.r >= 0 && c.g >= 0 && c.b >= 0 && std::isfinite(c.r + c.g + c.b)) [[likely]]
            return true;
        InvalidKind kind = InvalidKind::Negative;
        if (std::isnan(c.r) || std::isnan(c.g) || std::isnan(c.b)) {
            kind = InvalidKind::NotANumber;
        } else if (std::isinf(c.r) || std::isinf(c.g) || std::isinf(c.b)) {
            kind = InvalidKind::Infinite;
        } else if (c.r >= 0 && c.g >= 0 && c.b >= 0) {
            return true;  // only the sum overflowed
        }
        ++invalid[static_cast<std::size_t>(kind)];
        return false;
    }
    /// False when the value is refused.
    bool add_splat(const Vec2& raster, const Rgb& value) {
        if (!accept(value)) return false;
        if (!is_black(value)) splats.push_back({raster, value});
        return true;
    }
};

}  // namespace etendue
