#pragma once

#include <optional>

#include <etendue/scene_description.h>

#include "math/rgb.h"

namespace etendue {

/// Whether a transmission colour belongs to the inside, which absorbs, and not to every crossing.
[[nodiscard]] inline bool colors_the_inside(const ColorInput& color, double depth) {
    return depth > 0 && color.texture < 0;
}

/// Absorption coefficient mu inside of what the material bounds, per scene unit: exp(-mu depth) is the transmission
/// colour (OpenPBR 1.1, transmission_depth). Zero for clear bodies; empty when the surface bounds no inside that light
/// could reach. A colour of 0 absorbs as much as numbers can say.
[[nodiscard]] std::optional<Rgb> interior_absorption(const MaterialDesc& material);

}  // namespace etendue
