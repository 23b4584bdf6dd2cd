#include "session/wanted_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace etendue {
namespace {

/// Of relMSE times rays, even over adaptive; what is lost where nothing is gained was measured on the stages.
constexpr double kWorthwhile = 1.25;
/// Nothing is wanted so little that no number of passes would ever reach it.
constexpr double kLeastWanted = 1e-3;

/// relMSE times rays of passes that take so many samples of each tile's pixels, but for a constant.
double price(const std::vector<TileReport>& tiles, const std::vector<double>& samples) {
    double noise = 0;
    double rays = 0;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const TileReport& tile = tiles[i];
        noise += tile.pixels * (tile.noise.splats + tile.noise.camera / samples[i]);
        rays += tile.pixels * (tile.light_rays + tile.camera_rays * samples[i]);
    }
    return noise * rays;
}

/// One a pixel in the mean, but for what the least samples add.
std::vector<double> one_in_the_mean(const std::vector<TileReport>& tiles, std::vector<double> wanted) {
    double samples = 0;
    double pixels = 0;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        samples += tiles[i].pixels * wanted[i];
        pixels += tiles[i].pixels;
    }
    for (double& w : wanted) w = std::max(w * pixels / samples, kLeastSamples);
    return wanted;
}

}  // namespace

std::vector<double> wanted_samples(const std::vector<TileReport>& tiles) {
    std::vector<double> even(tiles.size(), 1);
    std::vector<double> wanted;
    for (const TileReport& tile : tiles) {
        // A half whose passes have sent no ray has seen no noise either.
        wanted.push_back(tile.camera_rays > 0 ? std::sqrt(tile.noise.camera / tile.camera_rays) : 0);
    }
    const double most = *std::max_element(wanted.begin(), wanted.end());
    if (!(most > 0) || !std::isfinite(most)) return even;
    for (double& w : wanted) w = std::max(w / most, kLeastWanted);
    return price(tiles, even) > kWorthwhile * price(tiles, one_in_the_mean(tiles, wanted)) ? wanted : even;
}

}  // namespace etendue
