#pragma once

#include <etendue/scene_description.h>

#include "bsdf/bsdf.h"
#include "bsdf/material_inputs.h"

namespace etendue {

/// What the parameters of UsdPreviewSurface and OpenPBR mean; the simplest model that has what the point needs.
[[nodiscard]] BsdfModel make_model(const PreviewSurfaceMaterial& material, const InputReader& read);
[[nodiscard]] BsdfModel make_model(const OpenPbrMaterial& material, const InputReader& read);

/// Lambert, or what it becomes with roughness.
[[nodiscard]] inline BsdfModel diffuse_model(const Rgb& reflectance, double roughness) {
    if (roughness > 0) return RoughDiffuse(reflectance, roughness);
    return Diffuse(reflectance);
}

/// Diffuse plus specular colour.
[[nodiscard]] Rgb albedo(const PreviewSurfaceMaterial& material, const InputReader& read);
[[nodiscard]] Rgb albedo(const OpenPbrMaterial& material, const InputReader& read);

}  // namespace etendue
