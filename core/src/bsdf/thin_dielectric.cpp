#include "bsdf/thin_dielectric.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bsdf/fresnel.h"
#include "bsdf/microfacet_reflection.h"
#include "bsdf/specular_albedo.h"
#include "math/frame.h"

namespace etendue {
namespace {

/// R' of R: with all reflections inside the slab.
double slab(double reflectance) { return 2 * reflectance / (1 + reflectance); }

/// Roughness shows only on a face that reflects or bends.
double effective_alpha(double ior, double alpha) { return ior == 1 ? 0 : alpha; }

}  // namespace

ThinDielectric::ThinDielectric(double ior, double alpha, const Rgb& reflection_tint, const Rgb& transmission_tint)
    : ior_(ior),
      alpha_(effective_alpha(ior, alpha)),
      transmission_alpha_(std::min(1.0, alpha_ * std::abs(ior - 1) / std::numbers::sqrt2)),
      f0_(slab(normal_reflectance(ior))),
      f90_(has_non_delta() ? grazing_reflectance(f0_, slab(mean_fresnel_dielectric(ior))) : 1),
      reflection_tint_(reflection_tint),
      transmission_tint_(transmission_tint) {}

/// T: exact when smooth, else never more than what the rough reflection leaves.
double ThinDielectric::transmittance(double cos) const {
    if (!has_non_delta()) return 1 - slab(fresnel_dielectric(cos, ior_));
    const SpecularAlbedo albedo = specular_albedo(cos, alpha_);
    return std::max(0.0, 1 - albedo.of_f0 * f0_ - albedo.of_f90 * f90_ - specular_albedo_margin(cos, alpha_));
}

double ThinDielectric::reflection_probability(double cos) const {
    const double t = transmittance(cos);
    const double reflected = (1 - t) * max_component(reflection_tint_);
    return reflected > 0 ? reflected / (reflected + t * max_component(transmission_tint_)) : 0;
}

Rgb ThinDielectric::eval(const Vec3& wo, const Vec3& wi) const {
    const double side = wo.z * wi.z;
    if (!has_non_delta() || side == 0) return Rgb();
    if (side > 0) {
        const MicrofacetReflection facet(Ggx(alpha_), wo, wi);
        const double s5 = pow5(std::max(0.0, 1 - facet.cos_m));
        return reflection_tint_ * (std::lerp(f0_, f90_, s5) * facet.value);
    }
    if (has_delta()) return Rgb();
    const double through = std::min(transmittance(std::abs(wo.z)), transmittance(std::abs(wi.z)));
    return transmission_tint_ * (through * MicrofacetReflection(Ggx(transmission_alpha_), wo, flip(wi)).value);
}

double ThinDielectric::pdf(const Vec3& wo, const Vec3& wi) const {
    const double side = wo.z * wi.z;
    if (!has_non_delta() || side == 0) return 0;
    const double p = reflection_probability(std::abs(wo.z));
    if (side > 0) return p * MicrofacetReflection(Ggx(alpha_), wo, wi).pdf_fwd;
    if (has_delta()) return 0;
    return (1 - p) * MicrofacetReflection(Ggx(transmission_alpha_), wo, flip(wi)).pdf_fwd;
}

std::optional<BsdfSample> ThinDielectric::sample(const Vec3& wo, double u_lobe, const Vec2& u) const {
    if (wo.z == 0) return std::nullopt;
    const double p = reflection_probability(std::abs(wo.z));
    const bool reflects = u_lobe < p;
    if (reflects && !has_non_delta()) return sample_mirror(wo, p);
    if (!reflects && has_delta()) return sample_straight(wo, 1 - p);

    BsdfSample sample;
    const Vec3 reflected = sample_microfacet_reflection(Ggx(reflects ? alpha_ : transmission_alpha_), wo, u);
    if (!(wo.z * reflected.z > 0)) return std::nullopt;
    sample.wi = reflects ? reflected : flip(reflected);
    sample.pdf_fwd = pdf(wo, sample.wi);
    if (!(sample.pdf_fwd >= kLeastPdf)) return std::nullopt;
    sample.pdf_rev = pdf(sample.wi, wo);
    sample.weight = eval(wo, sample.wi) * (std::abs(sample.wi.z) / sample.pdf_fwd);
    sample.transmission = !reflects;
    return sample;
}

BsdfSample ThinDielectric::sample_mirror(const Vec3& wo, double p) const {
    BsdfSample sample;
    sample.wi = {-wo.x, -wo.y, wo.z};
    sample.weight = reflection_tint_ * ((1 - transmittance(std::abs(wo.z))) / p);
    sample.pdf_fwd = sample.pdf_rev = p * std::abs(wo.z);
    sample.delta = true;
    return sample;
}

std::optional<BsdfSample> ThinDielectric::sample_straight(const Vec3& wo, double p) const {
    const double t = transmittance(std::abs(wo.z));
    if (!(t > 0) || is_black(transmission_tint_)) return std::nullopt;
    BsdfSample sample;
    sample.wi = -wo;
    sample.weight = transmission_tint_ * (t / p);
    sample.pdf_fwd = sample.pdf_rev = p * std::abs(wo.z);
    sample.delta = true;
    sample.transmission = true;
    return sample;
}

}  // namespace etendue
