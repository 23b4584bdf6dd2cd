#include "session/rare_light.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "film/splat_footprint.h"

namespace etendue {
namespace {

/// Rare is what shows a pixel this many times as bright as it is.
constexpr double kRare = 4;
/// Of 1 - w: where rounding leaves nothing, path tracing finds nothing.
constexpr double kLeastRest = 1e-15;

double gray(const Rgb& c) { return total(c) * (1.0 / 3); }

}  // namespace

RareLight::RareLight(const PixelWindow& window, std::vector<double> brightness, std::vector<Strategy> strategies,
                     double light_paths_per_pass)
    : window_(window),
      brightness_(std::move(brightness)),
      bright_(kDarkestPart * std::accumulate(brightness_.begin(), brightness_.end(), 0.0) /
              static_cast<double>(brightness_.size())),
      strategies_(std::move(strategies)),
      per_light_path_(1 / light_paths_per_pass),
      sum_(brightness_.size()) {}

void RareLight::add(const FilmTile& tile) {
    const auto tile_width = static_cast<std::size_t>(tile.window.x1 - tile.window.x0);
    for (const StrategySample& s : tile.strategies) {
        const Strategy strategy = strategies_[s.plane];
        if (strategy.s < 2) continue;
        if (strategy.t >= 2) {
            const int x = tile.window.x0 + static_cast<int>(s.sample % tile_width);
            const int y = tile.window.y0 + static_cast<int>(s.sample / tile_width);
            add(pixel_index(window_, x, y), gray(s.value), s.weight);
            continue;
        }
        const int x = static_cast<int>(std::floor(s.raster.x));
        const int y = static_cast<int>(std::floor(s.raster.y));
        if (x < window_.x0 || x >= window_.x1 || y < window_.y0 || y >= window_.y1) continue;
        add(pixel_index(window_, x, y), gray(s.value) * per_light_path_, s.weight);
    }
}

void RareLight::add(std::size_t pixel, double share, double weight) {
    const double seen = share * std::sqrt(weight / std::max(1 - weight, kLeastRest));
    const double above = seen - brightness_[pixel];
    if (seen > kRare * (brightness_[pixel] + bright_)) sum_[pixel] += weight * share * above;
}

std::vector<double> RareLight::variance(double passes) const {
    std::vector<double> out = sum_;
    for (double& value : out) value /= passes;
    return out;
}

}  // namespace etendue
