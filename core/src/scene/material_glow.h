#pragma once

#include "bsdf/material.h"
#include "light/emission_texture.h"

namespace etendue {

/// A material's own emission, as what varies a mesh light over its surface.
class MaterialGlow final : public EmissionTexture {
public:
    MaterialGlow(const MaterialDesc& material, const TextureSet& textures) : material_(material), textures_(textures) {}
    [[nodiscard]] Rgb at(const Vec2& st) const override { return material_emission(material_, textures_, st); }

private:
    const MaterialDesc& material_;
    const TextureSet& textures_;
};

}  // namespace etendue
