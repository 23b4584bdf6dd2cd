#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <etendue/film_view.h>
#include <etendue/render_settings.h>

#include "film/film_tile.h"
#include "film/filter.h"

namespace etendue {

/// Sums of each strategy's image, weighted and unweighted. A strategy with t >= 2 samples pixels, any other splats
/// (theory.md §2): the two are normalised as the picture's own sums are.
class StrategyPlanes {
public:
    StrategyPlanes(std::vector<Strategy> strategies, const PixelWindow& window);

    void add(const FilmTile& tile, const Filter& filter);
    /// The images, given the samples of each pixel and the light paths behind the sums.
    [[nodiscard]] std::vector<StrategyImage> images(const std::vector<std::uint32_t>& sample_counts,
                                                    std::uint64_t light_paths) const;

    /// Bytes, once all of them have arrived.
    [[nodiscard]] std::size_t memory_used() const;

private:
    /// Empty until something arrives.
    struct Plane {
        std::vector<Rgb> weighted;
        std::vector<Rgb> unweighted;
    };

    [[nodiscard]] bool samples_pixels(std::size_t plane) const { return strategies_[plane].t >= 2; }

    std::vector<Strategy> strategies_;
    PixelWindow window_;
    std::vector<Plane> planes_;  ///< one for each strategy
};

}  // namespace etendue
