#pragma once

#include <cstdint>
#include <optional>

#include "integrator/bdpt/strategies.h"
#include "integrator/bdpt/vertex.h"
#include "integrator/bdpt/weights.h"
#include "integrator/heuristic.h"
#include "integrator/render_context.h"
#include "math/sampler.h"

namespace etendue {

/// What one strategy (s, t) makes of its subpaths: C*_{s,t} of theory.md §2, and its weight.
struct Contribution {
    Rgb value;  ///< unweighted
    double weight = 0;
    Vec2 raster;  ///< where it lands; only of t <= 1
};

/// Joins subpaths. Strategies that carry nothing, or meet something in between, are empty. Visibility is tested last,
/// counted in `rays`.
class Connector {
public:
    Connector(const RenderContext& context, const ActiveStrategies& active)
        : context_(context),
          active_(active),
          heuristic_(context.settings.heuristic),
          absorbs_(context.scene.absorbs()) {}

    /// s = 0: the surface vertex i of the camera path emits.
    [[nodiscard]] std::optional<Contribution> emission(const CameraSubpath& camera, std::size_t i) const;
    /// s = 0: the camera path escaped to an infinite light.
    [[nodiscard]] std::optional<Contribution> infinite_emission(const Escape& escape, int light_index) const;
    /// s = 1: a light point chosen for z.
    [[nodiscard]] std::optional<Contribution> direct(const Vertex& z, Sampler& sampler, std::uint64_t& rays) const;
    /// s >= 2, t >= 2.
    [[nodiscard]] std::optional<Contribution> connect(const Vertex& y, const Vertex& z, std::uint64_t& rays) const;
    /// s >= 2, t = 1.
    [[nodiscard]] std::optional<Contribution> to_lens(const Vertex& y, Sampler& sampler, std::uint64_t& rays) const;
    /// s = 1, t = 1.
    [[nodiscard]] std::optional<Contribution> start_to_lens(const LightStart& start, Sampler& sampler,
                                                            std::uint64_t& rays) const;
    /// t = 0.
    [[nodiscard]] std::optional<Contribution> lens_hit(const LensCrossing& crossing) const;

private:
    /// Of the light point y seen from `receiver`, emitting along w.
    [[nodiscard]] LightDensities light_densities(int light_index, const LightPoint& y, const Vec3& receiver,
                                                 const Vec3& w) const;
    /// Takes away what the segment that leaves v along w absorbs.
    void absorb_from(const Vertex& v, const Vec3& w, double distance, Rgb& value) const;
    /// Density of the lens point from the vertex that it was joined to, over that of the lens sample.
    [[nodiscard]] double lens_ratio(double pdf_to_lens, const LensSample& lens) const;
    /// Turns the lens sample's pdf_dir into a density per area at p.
    [[nodiscard]] double area_from_lens(const LensSample& lens, const Vec3& p, const Vec3& n_g) const;
    [[nodiscard]] bool on_film(const Vec2& raster) const;

    const RenderContext& context_;
    const ActiveStrategies& active_;
    Heuristic heuristic_;
    bool absorbs_;  ///< bodies absorb light inside them
};

}  // namespace etendue
