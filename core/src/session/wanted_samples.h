#pragma once

#include <vector>

#include "film/camera_noise.h"

namespace etendue {

/// What passes of one sample a pixel have shown of a tile; noise and rays of one pass, by the pixel.
struct TileReport {
    double pixels = 0;
    TileNoise noise;
    double camera_rays = 0;
    double light_rays = 0;  ///< those of the light paths that are traced along
};

/// No tile has less than this part of the mean: noise may have been overlooked.
inline constexpr double kLeastSamples = 0.25;

/// In proportion to what do tiles get samples: 1 at most, and above 0.
///
/// With n samples and a cost of c each, a tile adds v / n to relMSE and c n to the time; for so much time relMSE is
/// least with n in proportion to sqrt(v / c). Costs are counted in rays: the clock would make pictures depend on the
/// machine. All get the same when the forecast gains little, say because splats make up the noise: a pixel's samples
/// are spread best when their number is a power of two, as that of renders often is, and that is then lost.
[[nodiscard]] std::vector<double> wanted_samples(const std::vector<TileReport>& tiles);

}  // namespace etendue
