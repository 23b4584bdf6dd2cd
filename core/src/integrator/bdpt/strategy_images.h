#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <etendue/render_settings.h>

#include "film/film_tile.h"
#include "integrator/bdpt/connection.h"
#include "integrator/bdpt/strategies.h"

namespace etendue {

/// Hands every strategy's contributions to the film one by one, beside the picture that they make together
/// (RenderSettings::strategy_images).
class StrategyImages {
public:
    /// Of the strategies that take part, those of paths with up to `longest` edges.
    StrategyImages(const ActiveStrategies& active, int longest);

    /// By path length, then s.
    [[nodiscard]] const std::vector<Strategy>& strategies() const { return strategies_; }

    /// t >= 2: belongs to that one of the tile's camera samples.
    void add_sample(const Contribution& c, int s, int t, std::size_t sample, FilmTile& tile) const;
    /// t <= 1.
    void add_splat(const Contribution& c, int s, int t, FilmTile& tile) const;

private:
    [[nodiscard]] std::optional<std::size_t> plane(int s, int t) const;

    int longest_;
    std::vector<Strategy> strategies_;
    std::vector<std::optional<std::size_t>> planes_;  ///< indices into strategies_, by path length and s
};

}  // namespace etendue
