#include <algorithm>
#include <cmath>

#include "bsdf/fresnel.h"
#include "bsdf/interior.h"
#include "bsdf/material_models.h"

namespace etendue {
namespace {

/// specular_weight dims the highlight by changing the index: eta' = (1 + e) / (1 - e), e = sgn(eta - 1) sqrt(weight F0)
/// (OpenPBR 1.1). Refraction bends by eta' too, and so does the squared-index factor of theory.md §5: reflection,
/// refraction and radiance then belong to one and the same interface. The text of OpenPBR leaves this open.
double modulated_ior(double ior, double specular_weight) {
    const double e = std::copysign(std::sqrt(specular_weight * normal_reflectance(ior)), ior - 1);
    return (1 + e) / (1 - e);
}

/// F90 of an interface that follows Schlick's curve.
double coat_f90(double ior) { return grazing_reflectance(normal_reflectance(ior), mean_fresnel_dielectric(ior)); }

/// OpenPBR's coat_darkening: of what the base reflects, the coat's inner side sends the part K = 1 - (1 - F0) / eta^2
/// back to it, so that its albedo E becomes E (1 - K) / (1 - E K). Glass sends on what comes back to it.
Rgb darkening(const Rgb& albedo, double coat_ior, double amount) {
    const double k = std::max(0.0, 1 - (1 - normal_reflectance(coat_ior)) / (coat_ior * coat_ior));
    const auto factor = [&](double e) { return 1 - amount + amount * (1 - k) / (1 - e * k); };
    return {factor(albedo.r), factor(albedo.g), factor(albedo.b)};
}

/// The dielectric, metal and diffuse parts of OpenPBR 1.1 at one point, and the coat over them. Below a coat, ior and
/// roughness stay those of the base in air.
struct OpenPbr {
    Rgb base;
    Rgb specular_color;
    Rgb transmission_color;
    bool clear_surface;  ///< transmission_color is that of the inside (interior.h)
    double diffuse_roughness;
    double metalness;
    double specular_weight;
    double transmission;
    double presence;
    double alpha;
    double ior;
    bool thin_walled;
    Clearcoat coat;
    Rgb darkened{1};  ///< factor on what is opaque below the coat

    OpenPbr(const OpenPbrMaterial& material, const InputReader& read)
        : base(read.reflectance(material.base_color) * read.fraction(material.base_weight)),
          specular_color(read.reflectance(material.specular_color)),
          transmission_color(read.reflectance(material.transmission_color)),
          clear_surface(!material.geometry_thin_walled &&
                        colors_the_inside(material.transmission_color, material.transmission_depth)),
          diffuse_roughness(read.fraction(material.base_diffuse_roughness)),
          metalness(read.fraction(material.base_metalness)),
          specular_weight(read.fraction(material.specular_weight)),
          transmission(read.fraction(material.transmission_weight)),
          presence(read.fraction(material.geometry_opacity)),
          alpha(read.alpha(material.specular_roughness)),
          ior(modulated_ior(usable_ior(material.specular_ior), specular_weight)),
          thin_walled(material.geometry_thin_walled) {
        const double coat_ior = usable_ior(material.coat_ior);
        const double weight = read.fraction(material.coat_weight);
        if (!(weight > 0) || coat_ior == 1) return;
        coat = {read.alpha(material.coat_roughness), weight * normal_reflectance(coat_ior),
                weight * coat_f90(coat_ior)};
        const Rgb base_albedo = lerp(metalness, base, base * specular_weight);
        darkened = darkening(base_albedo, coat_ior, weight * read.fraction(material.coat_darkening));
    }

    /// F82-tint: Schlick's curve from the base colour to white, brought down to specular_color times itself at cos =
    /// 1/7; all of it times specular_weight.
    [[nodiscard]] SchlickFresnel metal() const {
        constexpr double kCos = 1.0 / 7;
        constexpr double kRest = 1 - kCos;
        const Rgb at_82 = base + (Rgb(1) - base) * pow5(kRest);
        const Rgb dip = (Rgb(1) - specular_color) * at_82 / (kCos * pow5(kRest) * kRest);
        const Rgb scale = darkened * specular_weight;
        return {base * scale, scale, dip * scale};
    }

    [[nodiscard]] Dielectric glass() const {
        const Rgb tint = clear_surface ? Rgb(1) : transmission_color;
        return Dielectric(ior, alpha, specular_color, tint, thin_walled);
    }
};

LayeredParameters layers(const OpenPbr& surface) {
    LayeredParameters p;
    p.presence = surface.presence;
    p.alpha = surface.alpha;
    p.metal = surface.metalness;
    p.metal_fresnel = surface.metal();
    p.coated = (1 - surface.metalness) * (1 - surface.transmission);
    p.coat_f0 = Rgb(normal_reflectance(surface.ior));
    p.coat_f90 = Rgb(coat_f90(surface.ior));
    p.coat_tint = surface.specular_color * surface.darkened;
    p.diffuse = surface.base * surface.darkened;
    p.diffuse_roughness = surface.diffuse_roughness;
    p.glass = (1 - surface.metalness) * surface.transmission;
    p.glass_model = surface.glass();
    p.clearcoat = surface.coat;
    return p;
}

}  // namespace

BsdfModel make_model(const OpenPbrMaterial& material, const InputReader& read) {
    const OpenPbr surface(material, read);
    if (surface.presence == 1 && surface.coat.f90 == 0) {
        if (surface.metalness == 1) return Conductor(surface.metal(), surface.alpha);
        if (surface.metalness == 0 && surface.transmission == 1) return surface.glass();
        if (surface.metalness == 0 && surface.transmission == 0 && surface.ior == 1) {
            return diffuse_model(surface.base, surface.diffuse_roughness);
        }
    }
    return Layered(layers(surface));
}

Rgb albedo(const OpenPbrMaterial& material, const InputReader& read) {
    const OpenPbr surface(material, read);
    const double f0 = normal_reflectance(surface.ior);
    const Rgb highlight = surface.specular_color * f0;
    const Rgb opaque = (highlight + surface.base * (1 - f0)) * surface.darkened;
    const Rgb glass = highlight + surface.transmission_color * (1 - f0);
    const Rgb metal = surface.base * surface.specular_weight * surface.darkened;
    const Rgb substrate = lerp(surface.metalness, lerp(surface.transmission, opaque, glass), metal);
    return Rgb(surface.coat.f0) + substrate * (1 - surface.coat.f0);
}

}  // namespace etendue
