#include "integrator/bdpt/strategy_images.h"

namespace etendue {
namespace {

bool takes_part(const ActiveStrategies& active, int s, int t) {
    if (t == 0) return active.lens_hit;
    if (t == 1) return active.light_image;
    if (s == 0) return active.emission_hit;
    return s == 1 ? active.direct_light : active.connection;
}

/// Paths of k edges have k + 2 strategies, s = 0 ... k + 1.
std::size_t slot(int s, int t) {
    const int k = s + t - 1;
    return static_cast<std::size_t>((k - 1) * (k + 4) / 2 + s);
}

}  // namespace

StrategyImages::StrategyImages(const ActiveStrategies& active, int longest) : longest_(longest) {
    for (int k = 1; k <= longest; ++k) {
        for (int s = 0; s <= k + 1; ++s) {
            const int t = k + 1 - s;
            planes_.emplace_back();
            if (!takes_part(active, s, t)) continue;
            planes_.back() = strategies_.size();
            strategies_.push_back({s, t});
        }
    }
}

std::optional<std::size_t> StrategyImages::plane(int s, int t) const {
    if (s + t - 1 > longest_) return {};
    return planes_[slot(s, t)];
}

void StrategyImages::add_sample(const Contribution& c, int s, int t, std::size_t sample, FilmTile& tile) const {
    if (const auto p = plane(s, t)) tile.strategies.push_back({*p, sample, {}, c.value, c.weight});
}

void StrategyImages::add_splat(const Contribution& c, int s, int t, FilmTile& tile) const {
    if (const auto p = plane(s, t)) tile.strategies.push_back({*p, 0, c.raster, c.value, c.weight});
}

}  // namespace etendue
