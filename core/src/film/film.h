#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <etendue/film_view.h>
#include <etendue/render_settings.h>

#include "film/camera_noise.h"
#include "film/camera_sums.h"
#include "film/film_tile.h"
#include "film/filter.h"
#include "film/relative_error.h"
#include "film/replicate_sums.h"
#include "film/strategy_planes.h"

namespace etendue {

/// Sums of everything rendered so far. A pixel is the mean of its camera samples plus its splats over the number of
/// light paths. Not synchronised: the session adds tiles in one fixed order, which makes images independent of threads.
class Film {
public:
    /// `strategies`: those whose images are kept.
    Film(const RenderSettings& settings, const PixelWindow& window, std::vector<Strategy> strategies = {});

    void add(const FilmTile& tile);
    /// Closes a pass: only whole ones enter the variance.
    void end_pass();

    [[nodiscard]] RenderedImage image() const;
    /// Bytes, once everything that can has arrived; splats only where there are light paths.
    [[nodiscard]] std::size_t memory_used(bool light_paths) const;
    /// Whether the passes so far tell the picture's error: replicates are kept, and each has a complete one.
    [[nodiscard]] bool shows_error() const;
    /// Needs shows_error(); lives no longer than the next add().
    [[nodiscard]] RelativeError relative_error() const;
    /// Of a half; needs RenderSettings::adaptive and a complete pass of every replicate, and lives no longer than the
    /// next add().
    [[nodiscard]] CameraNoise camera_noise(std::uint64_t half) const;

private:
    [[nodiscard]] std::uint64_t replicate() const;
    void add_samples(const FilmTile& tile);
    void add_splat(const Splat& splat);
    [[nodiscard]] Rgb color(std::size_t pixel) const;
    void fill(Aov aov, std::span<float> out) const;

    RenderSettings settings_;
    Filter filter_;
    PixelWindow window_;
    CameraSums camera_;
    std::vector<Rgb> splat_;                   ///< empty until a splat arrives
    std::optional<ReplicateSums> replicates_;  ///< only if somebody has to know how far they are apart
    StrategyPlanes strategies_;
    std::uint64_t pass_light_paths_ = 0;
    RenderStatistics statistics_;
};

}  // namespace etendue
