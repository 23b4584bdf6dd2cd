#include "bsdf/material.h"

#include <cmath>
#include <variant>

#include "bsdf/interior.h"
#include "bsdf/material_models.h"

namespace etendue {
namespace {

BsdfModel make_model(const DiffuseMaterial& material, const InputReader& read) {
    return diffuse_model(read.reflectance(material.reflectance), read.fraction(material.roughness));
}

BsdfModel make_model(const ConductorMaterial& material, const InputReader& read) {
    return Conductor(read.reflectance(material.reflectance), read.alpha(material.roughness));
}

BsdfModel make_model(const DielectricMaterial& material, const InputReader& read) {
    const bool clear_surface =
        !material.thin_walled && colors_the_inside(material.transmission_tint, material.transmission_depth);
    return Dielectric(usable_ior(material.ior), read.alpha(material.roughness),
                      read.reflectance(material.reflection_tint),
                      clear_surface ? Rgb(1) : read.reflectance(material.transmission_tint), material.thin_walled);
}

/// A Phong lobe of this exponent is 1e-4 rad wide, which densities in double still resolve.
constexpr double kLargestExponent = 1e8;

BsdfModel make_model(const PhongMaterial& material, const InputReader& read) {
    return Phong(read.reflectance(material.reflectance), read.number(material.exponent, kLargestExponent),
                 material.form);
}

Rgb albedo(const DiffuseMaterial& material, const InputReader& read) { return read.reflectance(material.reflectance); }

Rgb albedo(const ConductorMaterial& material, const InputReader& read) {
    return read.reflectance(material.reflectance);
}

Rgb albedo(const DielectricMaterial& material, const InputReader& read) {
    return read.reflectance(material.transmission_tint);
}

Rgb albedo(const PhongMaterial& material, const InputReader& read) { return read.reflectance(material.reflectance); }

Vec3 normalize_or(const Vec3& v, const Vec3& otherwise) {
    const double l = length(v);
    return l > 0 && std::isfinite(l) ? v / l : otherwise;
}

/// Without tangents along the texture coordinates a tangent-space normal means nothing: n_s stays. The result may face
/// away from n_g; such directions are black, not wrong.
Vec3 mapped_normal(const TextureSet& textures, int texture, const SurfaceInteraction& si) {
    const Vec3 n = si.n_s;
    const Vec3 none;
    const Vec3 s = normalize_or(si.dpds - n * dot(n, si.dpds), none);
    if (s == none) return n;
    const Vec3 across = cross(n, s);
    const Vec3 t = dot(across, si.dpdt) < 0 ? -across : across;  // mirrored texture coordinates
    const TextureSet::Value m = textures.lookup(texture, si.st.x, si.st.y);
    return normalize_or(s * m[0] + t * m[1] + n * m[2], n);
}

}  // namespace

Bsdf make_bsdf(const MaterialDesc& material, const TextureSet& textures, const SurfaceInteraction& si) {
    const InputReader read(textures, si.st);
    const auto make = [&] { return std::visit([&](const auto& m) { return make_model(m, read); }, material.model); };
    return Bsdf(make, Frame::from_normal(shading_normal(material, textures, si)), si.n_g);
}

Vec3 shading_normal(const MaterialDesc& material, const TextureSet& textures, const SurfaceInteraction& si) {
    return material.normal_texture < 0 ? si.n_s : mapped_normal(textures, material.normal_texture, si);
}

Rgb material_emission(const MaterialDesc& material, const TextureSet& textures, const Vec2& st) {
    return InputReader(textures, st).radiance(material.emission);
}

Rgb material_albedo(const MaterialDesc& material, const TextureSet& textures, const Vec2& st) {
    const InputReader read(textures, st);
    return std::visit([&](const auto& m) { return albedo(m, read); }, material.model);
}

}  // namespace etendue
