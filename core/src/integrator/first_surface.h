#pragma once

#include <cstdint>
#include <optional>

#include "film/film_tile.h"
#include "integrator/render_context.h"

namespace etendue {

/// Fills what a pixel sample says of the first surface, as far as any AOV asks. `origin` on the lens and the unit
/// `direction` are those of the ray that met it.
inline void record_surface(const RenderContext& context, const Vec3& origin, const Vec3& direction,
                           const std::optional<SurfaceInteraction>& si, PixelSample& sample) {
    if (!context.wants_surface || !si) return;
    sample.hit = true;
    // Not the point's own place on the axis: where the ray leaves the lens at a grazing angle, that is less than the
    // float roundings of the point, and may come out negative.
    sample.depth = length(si->p - origin) * dot(direction, context.camera.forward());
    sample.normal = context.scene.shading_normal(*si);
    if (context.wants_albedo) sample.albedo = context.scene.albedo(*si);
}

/// Number of a pixel in the full image: a crop's camera samples draw the same random numbers.
inline std::uint64_t pixel_number(const RenderContext& context, int x, int y) {
    return static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(context.settings.width) +
           static_cast<std::uint64_t>(x);
}

}  // namespace etendue
