#include "bsdf/material.h"

#include <variant>

#include "bsdf/material_inputs.h"

namespace etendue {

Bsdf make_bsdf(const MaterialDesc& material, const TextureSet& textures, const SurfaceInteraction& si) {
    const InputReader read(textures, si.st);
    const auto& diffuse = std::get<DiffuseMaterial>(material.model);
    return Bsdf(Diffuse(read.reflectance(diffuse.reflectance)), Frame::from_normal(si.n_s), si.n_g);
}

Vec3 shading_normal(const MaterialDesc&, const TextureSet&, const SurfaceInteraction& si) { return si.n_s; }

Rgb material_emission(const MaterialDesc& material, const TextureSet& textures, const Vec2& st) {
    return InputReader(textures, st).radiance(material.emission);
}

Rgb material_albedo(const MaterialDesc& material, const TextureSet& textures, const Vec2& st) {
    return InputReader(textures, st).reflectance(std::get<DiffuseMaterial>(material.model).reflectance);
}

}  // namespace etendue
