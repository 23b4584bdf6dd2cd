#include "bsdf/conductor.h"

#include <cmath>

#include "bsdf/microfacet_reflection.h"

namespace etendue {

Rgb Conductor::eval(const Vec3& wo, const Vec3& wi, TransportMode, const AdjointPolicy&) const {
    if (has_delta() || !(wo.z * wi.z > 0)) return Rgb();
    const MicrofacetReflection reflection(Ggx(alpha_), wo, wi);
    return fresnel_(reflection.cos_m) * reflection.value;
}

double Conductor::pdf(const Vec3& wo, const Vec3& wi) const {
    if (has_delta() || !(wo.z * wi.z > 0)) return 0;
    return MicrofacetReflection(Ggx(alpha_), wo, wi).pdf_fwd;
}

std::optional<BsdfSample> Conductor::sample(const Vec3& wo, double, const Vec2& u, TransportMode,
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
    sample.wi = sample_microfacet_reflection(Ggx(alpha_), wo, u);
    if (!(wo.z * sample.wi.z > 0)) return std::nullopt;
    const MicrofacetReflection reflection(Ggx(alpha_), wo, sample.wi);
    sample.weight = fresnel_(reflection.cos_m) * (reflection.value * std::abs(sample.wi.z) / reflection.pdf_fwd);
    sample.pdf_fwd = reflection.pdf_fwd;
    sample.pdf_rev = reflection.pdf_rev;
    return sample;
}

}  // namespace etendue
