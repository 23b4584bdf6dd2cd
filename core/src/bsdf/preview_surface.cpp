#include "bsdf/fresnel.h"
#include "bsdf/material_models.h"

namespace etendue {
namespace {

/// UsdPreviewSurface 2.6 at one point.
struct PreviewSurface {
    Rgb diffuse;
    Rgb f0;
    Rgb f90{1};
    double metallic = 0;
    double opacity = 1;
    double presence = 1;
    double alpha = 0;
    double ior = 1.5;
    Clearcoat clearcoat;

    PreviewSurface(const PreviewSurfaceMaterial& material, const InputReader& read)
        : diffuse(read.reflectance(material.diffuse_color)),
          alpha(read.alpha(material.roughness)),
          ior(usable_ior(material.ior)) {
        if (material.use_specular_workflow) {
            f0 = read.reflectance(material.specular_color);
        } else {
            metallic = read.fraction(material.metallic);
            f0 = Rgb(normal_reflectance(ior));
        }
        // The specification gives f90 = 1 even where f0 = 0. Authors write ior 1 or a black specularColor to be rid of
        // the highlight altogether, and there is no interface then that could reflect.
        if (is_black(f0)) f90 = Rgb();

        const double amount = read.fraction(material.clearcoat);
        if (amount > 0 && ior != 1) {
            clearcoat = {read.alpha(material.clearcoat_roughness), amount * normal_reflectance(ior), amount};
        }

        const double authored = read.fraction(material.opacity);
        if (material.opacity_threshold > 0) {
            presence = authored >= material.opacity_threshold ? 1 : 0;
        } else if (material.opacity_mode == PreviewOpacityMode::Presence) {
            presence = authored;
        } else {
            opacity = authored;
        }
    }
};

LayeredParameters layers(const PreviewSurface& surface) {
    LayeredParameters p;
    p.presence = surface.presence;
    p.alpha = surface.alpha;
    p.metal = surface.metallic;
    p.metal_fresnel = {surface.diffuse, surface.diffuse, Rgb()};  // F0 = F90 = diffuseColor
    p.coated = (1 - surface.metallic) * surface.opacity;
    p.veil = (1 - surface.metallic) * (1 - surface.opacity);
    p.veil_ior = surface.ior;
    p.coat_f0 = surface.f0;
    p.coat_f90 = surface.f90;
    p.diffuse = surface.diffuse;
    p.clearcoat = surface.clearcoat;
    return p;
}

}  // namespace

/// opacityMode "transparent": opacity scales the diffuse part, the highlight stays, and what it leaves of the rest goes
/// through. The specification does not say whether that light bends; here it does, by ior, as the name says. Metal lets
/// nothing through. Transmission is smooth at any roughness. The clearcoat has the material's ior; how the layers share
/// the light is not specified either: Layered says how.
BsdfModel make_model(const PreviewSurfaceMaterial& material, const InputReader& read) {
    const PreviewSurface surface(material, read);
    if (surface.presence == 1 && surface.clearcoat.f90 == 0) {
        if (surface.metallic == 1) return Conductor({surface.diffuse, surface.diffuse, Rgb()}, surface.alpha);
        const bool solid = surface.metallic == 0 && surface.opacity == 1;
        if (solid && is_black(surface.f90)) return Diffuse(surface.diffuse);
        const bool clear = surface.metallic == 0 && surface.opacity == 0;
        if (clear && !material.use_specular_workflow && surface.alpha < kSmoothAlpha) return Dielectric(surface.ior, 0);
    }
    return Layered(layers(surface));
}

Rgb albedo(const PreviewSurfaceMaterial& material, const InputReader& read) {
    const PreviewSurface surface(material, read);
    const Rgb base = lerp(surface.opacity, Rgb(1), surface.diffuse);
    const Rgb dielectric = surface.f0 + (Rgb(1) - surface.f0) * base;
    const Rgb below = lerp(surface.metallic, dielectric, surface.diffuse);
    return Rgb(surface.clearcoat.f0) + below * (1 - surface.clearcoat.f0);
}

}  // namespace etendue
