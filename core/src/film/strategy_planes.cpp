#include "film/strategy_planes.h"

#include <utility>

#include "film/splat_footprint.h"

namespace etendue {
namespace {

std::size_t pixel_count(const PixelWindow& window) { return pixel_index(window, window.x0, window.y1); }

/// The pixel of a tile's sample; the tile lists them row by row.
std::size_t pixel_of_sample(const PixelWindow& window, const PixelWindow& tile, std::size_t sample) {
    const auto width = static_cast<std::size_t>(tile.x1 - tile.x0);
    return pixel_index(window, tile.x0 + static_cast<int>(sample % width), tile.y0 + static_cast<int>(sample / width));
}

void append(std::vector<float>& out, const Rgb& value) {
    out.insert(out.end(), {static_cast<float>(value.r), static_cast<float>(value.g), static_cast<float>(value.b)});
}

}  // namespace

StrategyPlanes::StrategyPlanes(std::vector<Strategy> strategies, const PixelWindow& window)
    : strategies_(std::move(strategies)), window_(window), planes_(strategies_.size()) {}

std::size_t StrategyPlanes::memory_used() const { return strategies_.size() * 2 * pixel_count(window_) * sizeof(Rgb); }

void StrategyPlanes::add(const FilmTile& tile, const Filter& filter) {
    for (const StrategySample& s : tile.strategies) {
        Plane& plane = planes_[s.plane];
        if (plane.weighted.empty()) {
            plane.weighted.resize(pixel_count(window_));
            plane.unweighted.resize(pixel_count(window_));
        }
        const auto add_to = [&](std::size_t pixel, double share) {
            plane.weighted[pixel] += s.value * (s.weight * share);
            plane.unweighted[pixel] += s.value * share;
        };
        if (samples_pixels(s.plane)) {
            add_to(pixel_of_sample(window_, tile.window, s.sample), 1);
        } else {
            spread_splat(filter, window_, s.raster, add_to);
        }
    }
}

std::vector<StrategyImage> StrategyPlanes::images(const std::vector<std::uint32_t>& sample_counts,
                                                  std::uint64_t light_paths) const {
    std::vector<StrategyImage> images;
    for (std::size_t i = 0; i < strategies_.size(); ++i) {
        for (const bool weighted : {true, false}) {
            const std::vector<Rgb>& sums = weighted ? planes_[i].weighted : planes_[i].unweighted;
            StrategyImage& image = images.emplace_back(StrategyImage{strategies_[i], weighted, {}});
            image.data.reserve(3 * sample_counts.size());
            if (sums.empty()) image.data.resize(3 * sample_counts.size());
            for (std::size_t pixel = 0; pixel < sums.size(); ++pixel) {
                // What nothing was taken from has no sum either.
                const auto count = samples_pixels(i) ? sample_counts[pixel] : static_cast<double>(light_paths);
                append(image.data, count > 0 ? sums[pixel] / count : Rgb());
            }
        }
    }
    return images;
}

}  // namespace etendue
