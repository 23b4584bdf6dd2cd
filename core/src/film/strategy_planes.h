#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <etendue/film_view.h>
#include <etendue/render_settings.h>

#include "film/camera_sums.h"
#include "film/film_tile.h"
#include "film/filter.h"

namespace etendue {

/// Sums of each strategy's image, weighted and unweighted. A strategy with t >= 2 samples pixels, any other splats
/// (theory.md §2): the two are normalised as the picture's own sums are.
class StrategyPlanes {
public:
    /// `parts`: CameraSums::parts().
    StrategyPlanes(std::vector<Strategy> strategies, const PixelWindow& window, std::size_t parts);

    /// `part`: CameraSums::part_of() the pass.
    void add(const FilmTile& tile, const Filter& filter, std::size_t part);
    /// The images, given what the camera samples weigh and the light paths behind the sums.
    [[nodiscard]] std::vector<StrategyImage> images(const CameraSums& camera, std::uint64_t light_paths) const;

    /// Bytes, once all of them have arrived.
    [[nodiscard]] std::size_t memory_used() const;

private:
    /// Empty until something arrives.
    struct Plane {
        std::vector<Rgb> weighted;
        std::vector<Rgb> unweighted;
    };

    using Parts = std::vector<Plane>;  ///< a splatting strategy uses one of them

    [[nodiscard]] bool samples_pixels(std::size_t strategy) const { return strategies_[strategy].t >= 2; }
    /// Splats weigh alike whichever part they came with.
    [[nodiscard]] Rgb pixel(std::size_t strategy, bool weighted, std::size_t pixel, const CameraSums& camera,
                            std::uint64_t light_paths) const;

    std::vector<Strategy> strategies_;
    PixelWindow window_;
    std::vector<Parts> planes_;  ///< of each strategy
};

}  // namespace etendue
