#pragma once

#include <cstdint>
#include <optional>

#include "film/film_tile.h"
#include "integrator/render_context.h"

namespace etendue {

/// Fills what a pixel sample says of the first surface, as far as any AOV asks.
inline void record_surface(const RenderContext& context, const std::optional<SurfaceInteraction>& si,
                           PixelSample& sample) {
    if (!context.wants_surface || !si) return;
    sample.hit = true;
    sample.depth = context.camera.depth(si->p);
    sample.normal = context.scene.shading_normal(*si);
    if (context.wants_albedo) sample.albedo = context.scene.albedo(*si);
}

/// Number of a pixel in the full image: a crop's camera samples draw the same random numbers.
inline std::uint64_t pixel_number(const RenderContext& context, int x, int y) {
    return static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(context.settings.width) +
           static_cast<std::uint64_t>(x);
}

}  // namespace etendue
