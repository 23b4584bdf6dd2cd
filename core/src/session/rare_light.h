#pragma once

#include <cstdint>
#include <vector>

#include "film/film_tile.h"

namespace etendue {

/// The noise that path tracing has from light it hardly ever finds, such as the caustics of small lamps: as seen by
/// bdpt, which finds it by light paths. A short trial of path tracing itself sees none of it, and takes the picture for
/// quiet and dark.
///
/// A light path's share C of a pixel has the weight w = n^2 / (n^2 + p^2 + ...) of the power heuristic, with n and p
/// the densities of finding its path from the light and by path tracing. So p / n <= sqrt((1 - w) / w), and whenever
/// path tracing finds it, it sees at least x = C sqrt(w / (1 - w)). The mean of w C (x - m) over all that bdpt finds is
/// the part of path tracing's variance, in a pixel of mean m, that is from there (Grittmann et al. 2022 predict the
/// variance of other strategies by the samples of those at hand alike). Counted is what is much brighter than the
/// pixel: the rest any trial sees.
class RareLight {
public:
    /// `brightness`: of the window's pixels. Tiles are those of bdpt with strategy images, of the power heuristic.
    RareLight(const PixelWindow& window, std::vector<double> brightness, std::vector<Strategy> strategies,
              double light_paths_per_pass);

    void add(const FilmTile& tile);
    /// Variance, of one sample per pixel, from so many passes of tiles; over the pixels, in their order.
    [[nodiscard]] std::vector<double> variance(double passes) const;

private:
    void add(std::size_t pixel, double share, double weight);

    PixelWindow window_;
    std::vector<double> brightness_;
    double bright_ = 0;  ///< added to each pixel's
    std::vector<Strategy> strategies_;
    double per_light_path_;
    std::vector<double> sum_;
};

}  // namespace etendue
