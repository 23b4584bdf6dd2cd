#include "film/strategy_planes.h"

#include <utility>

#include "film/splat_footprint.h"

namespace etendue {
namespace {

std::size_t pixel_count(const PixelWindow& window) { return pixel_index(window, window.x0, window.y1); }

/// The pixel of a tile's sample, as FilmTile::samples lists them.
std::size_t pixel_of_sample(const PixelWindow& window, const PixelWindow& tile, std::size_t sample) {
    const auto width = static_cast<std::size_t>(tile.x1 - tile.x0);
    const std::size_t pixel = sample % (width * static_cast<std::size_t>(tile.y1 - tile.y0));
    return pixel_index(window, tile.x0 + static_cast<int>(pixel % width), tile.y0 + static_cast<int>(pixel / width));
}

void append(std::vector<float>& out, const Rgb& value) {
    out.insert(out.end(), {static_cast<float>(value.r), static_cast<float>(value.g), static_cast<float>(value.b)});
}

}  // namespace

StrategyPlanes::StrategyPlanes(std::vector<Strategy> strategies, const PixelWindow& window, std::size_t parts)
    : strategies_(std::move(strategies)), window_(window), planes_(strategies_.size(), Parts(parts)) {}

std::size_t StrategyPlanes::memory_used() const {
    std::size_t planes = 0;
    for (std::size_t strategy = 0; strategy < strategies_.size(); ++strategy) {
        planes += samples_pixels(strategy) ? planes_[strategy].size() : 1;
    }
    return planes * 2 * pixel_count(window_) * sizeof(Rgb);
}

void StrategyPlanes::add(const FilmTile& tile, const Filter& filter, std::size_t part) {
    for (const StrategySample& s : tile.strategies) {
        Plane& plane = planes_[s.plane][samples_pixels(s.plane) ? part : 0];
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

Rgb StrategyPlanes::pixel(std::size_t strategy, bool weighted, std::size_t pixel, const CameraSums& camera,
                          std::uint64_t light_paths) const {
    const bool by_camera = samples_pixels(strategy);
    Rgb sum;
    for (std::size_t part = 0; part < planes_[strategy].size(); ++part) {
        const Plane& plane = planes_[strategy][part];
        const std::vector<Rgb>& sums = weighted ? plane.weighted : plane.unweighted;
        // What nothing was taken from has no sum either.
        if (!sums.empty()) sum += sums[pixel] * (by_camera ? camera.weight(part, pixel) : 1);
    }
    if (by_camera) return sum / camera.samples(pixel);
    return light_paths > 0 ? sum / static_cast<double>(light_paths) : Rgb();
}

std::vector<StrategyImage> StrategyPlanes::images(const CameraSums& camera, std::uint64_t light_paths) const {
    std::vector<StrategyImage> images;
    for (std::size_t i = 0; i < strategies_.size(); ++i) {
        for (const bool weighted : {true, false}) {
            StrategyImage& image = images.emplace_back(StrategyImage{strategies_[i], weighted, {}});
            image.data.reserve(3 * camera.pixels());
            for (std::size_t p = 0; p < camera.pixels(); ++p) {
                append(image.data, pixel(i, weighted, p, camera, light_paths));
            }
        }
    }
    return images;
}

}  // namespace etendue
