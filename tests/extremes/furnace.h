#pragma once

#include <etendue/render_settings.h>
#include <etendue/scene_description.h>

namespace etendue::test {

/// The sky: radiance 1 from everywhere.
[[nodiscard]] LightDesc white_sky();

/// A ball of radius 1 that fills the view, under the white sky: what absorbs nothing cannot be seen.
[[nodiscard]] SceneDescription furnace(const MaterialModel& ball);

/// No path is cut short, by depth or by chance: what only carries light on gives every sample the same value.
[[nodiscard]] RenderSettings endless(IntegratorKind integrator, int samples_per_pixel);

}  // namespace etendue::test
