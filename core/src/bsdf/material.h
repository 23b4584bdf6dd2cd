#pragma once

#include <etendue/scene_description.h>

#include "bsdf/bsdf.h"
#include "geometry/surface_interaction.h"
#include "math/rgb.h"
#include "texture/texture_set.h"

namespace etendue {

/// The BSDF of a material at a point: textures looked up, parameters given their meaning, normal map applied.
[[nodiscard]] Bsdf make_bsdf(const MaterialDesc& material, const TextureSet& textures, const SurfaceInteraction& si);

/// The normal that make_bsdf shades with: the mesh's, and the normal map on top of it.
[[nodiscard]] Vec3 shading_normal(const MaterialDesc& material, const TextureSet& textures,
                                  const SurfaceInteraction& si);

/// Radiance that the material emits on its front side at st, nits.
[[nodiscard]] Rgb material_emission(const MaterialDesc& material, const TextureSet& textures, const Vec2& st);

/// Diffuse plus specular colour for the albedo AOV.
[[nodiscard]] Rgb material_albedo(const MaterialDesc& material, const TextureSet& textures, const Vec2& st);

}  // namespace etendue
