#pragma once

#include <cstdint>

#include "integrator/bdpt/strategies.h"
#include "integrator/bdpt/vertex.h"
#include "integrator/heuristic.h"
#include "integrator/render_context.h"
#include "math/sampler.h"

namespace etendue {

/// Traces subpaths and keeps, at each vertex, what weights need of the vertices before it.
class SubpathTracer {
public:
    SubpathTracer(const RenderContext& context, const ActiveStrategies& active)
        : context_(context),
          active_(active),
          heuristic_(context.settings.heuristic),
          absorbs_(context.scene.absorbs()) {}

    /// `rays` counts intersections. The path keeps its memory between calls.
    void trace_light(Sampler& sampler, LightSubpath& path, std::uint64_t& rays) const;
    void trace_camera(const Vec2& raster, Sampler& sampler, CameraSubpath& path, std::uint64_t& rays) const;

private:
    struct Walk;
    [[nodiscard]] bool scatter(Walk& walk, Vertex& vertex, TransportMode mode, Sampler& sampler) const;
    [[nodiscard]] MisState arrive(const Walk& walk, double area_to, double area_back) const;
    void add_vertex(const Walk& walk, const SurfaceInteraction& si, const MisState& mis,
                    std::vector<Vertex>& vertices) const;
    /// What absorption leaves of light between the vertex left and p.
    [[nodiscard]] Rgb left_of(const Walk& walk, const Vec3& p) const;
    void add_crossing(const Walk& walk, double t_max, LightSubpath& path) const;
    [[nodiscard]] std::optional<Walk> start_light(Sampler& sampler, LightSubpath& path) const;
    [[nodiscard]] MisState first_light_state(const Walk& walk, const LightStart& start, const Vec3& receiver,
                                             double area_to, double area_back) const;
    [[nodiscard]] MisState first_camera_state(const CameraRay& ray, double area_to, double area_back) const;

    const RenderContext& context_;
    const ActiveStrategies& active_;
    Heuristic heuristic_;
    bool absorbs_;  ///< bodies absorb light inside them
};

}  // namespace etendue
