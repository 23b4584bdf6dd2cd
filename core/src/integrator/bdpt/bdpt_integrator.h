#pragma once

#include <optional>
#include <vector>

#include "integrator/bdpt/connection.h"
#include "integrator/bdpt/strategies.h"
#include "integrator/bdpt/strategy_images.h"
#include "integrator/bdpt/subpath.h"
#include "integrator/integrator.h"
#include "integrator/random_streams.h"

namespace etendue {

/// Bidirectional path tracing (Veach 10): all strategies that scene, camera and settings allow. Particle tracing is the
/// subset t = 1.
class BdptIntegrator final : public Integrator {
public:
    explicit BdptIntegrator(const RenderContext& context);
    // The tracer and the connector refer to members.
    BdptIntegrator(const BdptIntegrator&) = delete;
    BdptIntegrator& operator=(const BdptIntegrator&) = delete;

    void render(const WorkUnit& unit, FilmTile& tile) const override;
    [[nodiscard]] std::uint64_t light_paths_per_pass() const override;
    [[nodiscard]] std::vector<Strategy> image_strategies() const override;

private:
    void trace_light_paths(const WorkUnit& unit, std::uint64_t begin, std::uint64_t end, LightSubpath& path,
                           FilmTile& tile) const;
    void splat_light_path(const LightSubpath& path, Sampler& sampler, FilmTile& tile) const;
    /// `sample`: which one of the tile's.
    void sample_camera(const WorkUnit& unit, std::size_t sample, const LightSubpath& light, CameraSubpath& camera,
                       FilmTile& tile) const;
    void record_first_surface(const Vec2& raster, Sampler& sampler, PixelSample& sample, FilmTile& tile) const;
    void add_camera_strategies(const CameraSubpath& camera, const LightSubpath& light, Sampler& sampler,
                               std::size_t sample, FilmTile& tile) const;
    /// The contribution as the settings ask for it: weighted, or one strategy alone, unweighted.
    [[nodiscard]] Rgb weigh(const Contribution& c, int s, int t) const;
    void add(const std::optional<Contribution>& c, int s, int t, std::size_t sample, FilmTile& tile) const;
    void splat(const std::optional<Contribution>& c, int s, int t, FilmTile& tile) const;

    RenderContext context_;
    ActiveStrategies active_;
    RandomStreams streams_;
    SubpathTracer tracer_;
    Connector connector_;
    std::optional<StrategyImages> images_;  ///< empty unless asked for
};

}  // namespace etendue
