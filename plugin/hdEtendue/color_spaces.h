#pragma once

#include <string>

#include <etendue/scene_description.h>

#include "usd.h"
#include "warnings.h"

namespace etendue::hydra {

/// `rgb` in linear Rec.709. An unknown space is warned about and taken as linear Rec.709; an empty one is that.
[[nodiscard]] Color to_rendering_space(Warnings& warnings, const SdfPath& path, const std::string& space,
                                       const Color& rgb);

/// What the colour space authored for a texture's file says; Auto, after a warning, for one that is not supported.
[[nodiscard]] TextureColorSpace file_color_space(Warnings& warnings, const SdfPath& path, const std::string& space);

}  // namespace etendue::hydra
