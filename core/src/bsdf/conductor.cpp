#include "bsdf/conductor.h"

#include <cmath>

#include "bsdf/microfacet_reflection.h"
#include "bsdf/multiple_scattering.h"
#include "math/sampling.h"

namespace etendue {

/// Of sampling the lobe of multiple scattering: nearly its share of the albedo.
double Conductor::multiple_probability(double cos) const {
    const MultipleScattering multiple(alpha_);
    if (!multiple.exists()) return 0;
    const double more = lost_albedo(cos, alpha_) * max_component(multiple.reflectance(fresnel_));
    const double single = max_component(specular_albedo(cos, alpha_)(fresnel_.f0, fresnel_.f90));
    return more > 0 ? more / (more + single) : 0;
}

Conductor::Scattering Conductor::scattering(const Vec3& wo, const Vec3& wi) const {
    const MicrofacetReflection single(Ggx(alpha_), wo, wi);
    Scattering s{fresnel_(single.cos_m) * single.value, single.pdf_fwd, single.pdf_rev};
    const MultipleScattering multiple(alpha_);
    if (multiple.exists()) {
        const double cos_o = std::abs(wo.z);
        const double cos_i = std::abs(wi.z);
        s.f += multiple.reflectance(fresnel_) * multiple.value(cos_o, cos_i);
        s.pdf_fwd = std::lerp(single.pdf_fwd, cos_i * kInvPi, multiple_probability(cos_o));
        s.pdf_rev = std::lerp(single.pdf_rev, cos_o * kInvPi, multiple_probability(cos_i));
    }
    return s;
}

Rgb Conductor::eval(const Vec3& wo, const Vec3& wi, TransportMode, const AdjointPolicy&) const {
    if (has_delta() || !(wo.z * wi.z > 0)) return Rgb();
    return scattering(wo, wi).f;
}

double Conductor::pdf(const Vec3& wo, const Vec3& wi) const {
    if (has_delta() || !(wo.z * wi.z > 0)) return 0;
    return scattering(wo, wi).pdf_fwd;
}

std::optional<BsdfSample> Conductor::sample(const Vec3& wo, double u_lobe, const Vec2& u, TransportMode,
                                            const AdjointPolicy&) const {
    if (wo.z == 0) return std::nullopt;
    BsdfSample sample;
    if (has_delta()) {
        sample.wi = {-wo.x, -wo.y, wo.z};
        sample.weight = fresnel_(std::abs(wo.z));
        sample.pdf_fwd = sample.pdf_rev = std::abs(wo.z);
        sample.delta = true;
        return sample;
    }
    if (u_lobe < multiple_probability(std::abs(wo.z))) {
        sample.wi = sample_cosine_hemisphere(u);
        sample.wi.z = std::copysign(sample.wi.z, wo.z);
    } else {
        sample.wi = sample_microfacet_reflection(Ggx(alpha_), wo, u);
    }
    if (!(wo.z * sample.wi.z > 0)) return std::nullopt;
    const Scattering s = scattering(wo, sample.wi);
    sample.weight = s.f * (std::abs(sample.wi.z) / s.pdf_fwd);
    sample.pdf_fwd = s.pdf_fwd;
    sample.pdf_rev = s.pdf_rev;
    return sample;
}

}  // namespace etendue
