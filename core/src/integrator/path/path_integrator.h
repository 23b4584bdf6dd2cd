#pragma once

#include <etendue/render_settings.h>

#include "integrator/heuristic.h"
#include "integrator/integrator.h"
#include "integrator/random_streams.h"

namespace etendue {

/// Path tracing from the camera: s = 0 and s = 1 combined by MIS. The reference for bdpt, so it shares none of its
/// code.
class PathIntegrator final : public Integrator {
public:
    explicit PathIntegrator(const RenderContext& context);

    void render(const WorkUnit& unit, FilmTile& tile) const override;
    [[nodiscard]] std::uint64_t light_paths_per_pass() const override { return 0; }

private:
    struct Walk;

    // Absorbs: bodies absorb light inside them; who has none pays nothing for those who do.
    template <bool Absorbs>
    void sample_pixels(const WorkUnit& unit, std::uint64_t number, FilmTile& tile) const;
    template <bool Absorbs>
    [[nodiscard]] PixelSample sample_pixel(const Vec2& raster, Sampler& sampler, FilmTile& tile) const;
    void add_emission(const SurfaceInteraction& si, const Walk& walk, PixelSample& sample, FilmTile& tile) const;
    void add_infinite(const Walk& walk, PixelSample& sample, FilmTile& tile) const;
    template <bool Absorbs>
    void add_direct(const SurfaceInteraction& si, const Bsdf& bsdf, const Walk& walk, Sampler& sampler,
                    PixelSample& sample, FilmTile& tile) const;
    [[nodiscard]] double hit_weight(const Walk& walk, double pdf_hit, double pdf_direct) const;

    RenderContext context_;
    Heuristic heuristic_;
    RandomStreams streams_;
};

}  // namespace etendue
