#pragma once

#include <vector>

#include <etendue/scene_description.h>

#include "geometry/surface_interaction.h"
#include "math/rgb.h"
#include "scene/media.h"

namespace etendue {

/// Nothing absorbs, and the compiler knows.
class Absorption {
public:
    explicit Absorption(const std::vector<MaterialDesc>&) {}

    [[nodiscard]] static constexpr bool any() { return false; }
    [[nodiscard]] static MediumId medium(const SurfaceInteraction&) { return 0; }
    [[nodiscard]] static Media beyond(const Media&, const SurfaceInteraction&, const Vec3&, const Vec3&) { return {}; }
    [[nodiscard]] static Rgb transmittance(const Media&, double) { return Rgb(1); }
};

}  // namespace etendue
