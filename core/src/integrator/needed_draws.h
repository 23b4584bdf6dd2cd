#pragma once

#include "integrator/render_context.h"
#include "math/sampler.h"

namespace etendue {

/// Draws that some scenes have no use for: the evenly spread ones are few, and all cost time.

/// Chooses a point of the lens; a pinhole has but one.
inline Vec2 draw_lens(const RenderContext& context, Sampler& sampler) {
    return context.camera.has_lens() ? sampler.next_2d() : Vec2{};
}

/// Chooses a light; one alone is just taken.
inline double draw_light(const RenderContext& context, Sampler& sampler) {
    return context.scene.light_count() > 1 ? sampler.next_1d() : 0;
}

}  // namespace etendue
