#include "bsdf/dielectric.h"

#include <algorithm>

#include "bsdf/fresnel.h"
#include "bsdf/microfacet_reflection.h"
#include "math/frame.h"

namespace etendue {
namespace {

double squared(double x) { return x * x; }

}  // namespace

double Dielectric::reflection_probability(double fresnel) const {
    const double reflected = fresnel * max_component(reflection_tint_);
    const double transmitted = (1 - fresnel) * max_component(transmission_tint_);
    return reflected > 0 ? reflected / (reflected + transmitted) : 0;
}

Dielectric::Scattering Dielectric::reflection(const Vec3& wo, const Vec3& wi) const {
    const MicrofacetReflection facet(Ggx(alpha_), wo, wi);
    const double eta_o = eta(wo);
    const double fresnel = fresnel_dielectric(facet.cos_m, eta(flip(wo)) / eta_o);
    const double p = reflection_probability(fresnel);
    return {reflection_tint_ * (fresnel * facet.value), p * facet.pdf_fwd, p * facet.pdf_rev};
}

Dielectric::Scattering Dielectric::refraction(const Vec3& wo, const Vec3& wi) const {
    const double eta_o = eta(wo);
    const double eta_i = eta(wi);
    Vec3 h = wo * eta_o + wi * eta_i;  // Walter 2007 eq. 16, turned to wo's side below
    if (h.z * wo.z < 0) h = -h;
    const double h2 = length_squared(h);
    const double o_h = dot(wo, h);
    const double i_h = -dot(wi, h);
    if (!(o_h > 0 && i_h > 0)) return {};  // the facet is seen from behind

    const Ggx ggx(alpha_);
    const double h_length = std::sqrt(h2);
    const double cos_om = o_h / h_length;
    const double cos_im = i_h / h_length;
    const double fresnel = fresnel_crossing(cos_om, eta_o, cos_im, eta_i);
    const double p = 1 - reflection_probability(fresnel);
    const double d = ggx.d(h);
    const double cos_o = std::abs(wo.z);
    const double cos_i = std::abs(wi.z);
    const double a_o = ggx.a(wo);
    const double a_i = ggx.a(wi);
    // dm / dwi = eta_i^2 |wi . m| / (eta_o wo . m + eta_i wi . m)^2 (eq. 17); the denominator is |h|^2.
    const double visible_o = d * Ggx::g1_over_cos(cos_o, a_o) * cos_om;
    const double visible_i = d * Ggx::g1_over_cos(cos_i, a_i) * cos_im;
    // eq. 21 with light leaving along wi, as particles do: eta_i^2 belongs to the direction that is left.
    const double f =
        cos_om * cos_im * Ggx::g2_over_cosines(cos_o, a_o, cos_i, a_i) * squared(eta_i) * (1 - fresnel) * d / h2;
    return {transmission_tint_ * f, p * visible_o * squared(eta_i) * cos_im / h2,
            p * visible_i * squared(eta_o) * cos_om / h2};
}

Dielectric::Scattering Dielectric::scattering(const Vec3& wo, const Vec3& wi) const {
    const double side = wo.z * wi.z;
    if (side > 0) return reflection(wo, wi);
    if (side < 0) return refraction(wo, wi);
    return {};
}

Rgb Dielectric::eval(const Vec3& wo, const Vec3& wi, TransportMode mode, const AdjointPolicy& policy) const {
    if (thin_walled_) return thin().eval(wo, wi);
    if (smooth()) return Rgb();
    return scattering(wo, wi).f * squared_index_factor(mode, eta(wo), eta(wi), policy);
}

double Dielectric::pdf(const Vec3& wo, const Vec3& wi) const {
    if (thin_walled_) return thin().pdf(wo, wi);
    return smooth() ? 0 : scattering(wo, wi).pdf_fwd;
}

std::optional<BsdfSample> Dielectric::sample(const Vec3& wo, double u_lobe, const Vec2& u, TransportMode mode,
                                             const AdjointPolicy& policy) const {
    if (wo.z == 0) return std::nullopt;
    if (thin_walled_) return thin().sample(wo, u_lobe, u);
    if (smooth()) return sample_smooth(wo, u_lobe, mode, policy);

    const Vec3 up = wo.z > 0 ? wo : flip(wo);
    const double eta_o = eta(wo);
    const double eta_t = eta(flip(wo));
    const Vec3 m = Ggx(alpha_).sample_visible(up, u);
    const double cos_om = dot(up, m);
    const double fresnel = fresnel_dielectric(cos_om, eta_t / eta_o);
    Vec3 wi;
    if (u_lobe < reflection_probability(fresnel)) {
        wi = m * (2 * cos_om) - up;
        if (wi.z <= 0) return std::nullopt;
    } else {
        if (fresnel >= 1) return std::nullopt;
        const double ratio = eta_o / eta_t;
        wi = m * (ratio * cos_om - refracted_cos(cos_om, eta_t / eta_o)) - up * ratio;
        if (wi.z >= 0) return std::nullopt;
    }
    if (wo.z < 0) wi = flip(wi);

    const Scattering s = scattering(wo, wi);
    if (!(s.pdf_fwd >= kLeastPdf)) return std::nullopt;
    BsdfSample sample;
    sample.wi = wi;
    const double index_factor = squared_index_factor(mode, eta_o, eta(wi), policy);
    sample.weight = s.f * (index_factor * std::abs(wi.z) / s.pdf_fwd);
    sample.pdf_fwd = s.pdf_fwd;
    sample.pdf_rev = s.pdf_rev;
    sample.transmission = wo.z * wi.z < 0;
    sample.radiance_scale = squared(eta_o / eta(wi));
    return sample;
}

std::optional<BsdfSample> Dielectric::sample_smooth(const Vec3& wo, double u_lobe, TransportMode mode,
                                                    const AdjointPolicy& policy) const {
    const double eta_o = eta(wo);
    const double eta_t = eta(flip(wo));
    const double cos_o = std::abs(wo.z);
    const double fresnel = fresnel_dielectric(cos_o, eta_t / eta_o);
    const double p_reflection = reflection_probability(fresnel);
    BsdfSample sample;
    if (u_lobe < p_reflection) {
        sample.wi = {-wo.x, -wo.y, wo.z};
        sample.weight = reflection_tint_ * (fresnel / p_reflection);
        set_delta_pdfs(sample, wo, p_reflection, p_reflection, eta_o, eta_o);
        return sample;
    }
    const double p = 1 - p_reflection;
    const double cos_t = eta_t == eta_o ? cos_o : refracted_cos(cos_o, eta_t / eta_o);
    if (!(cos_t > 0) || is_black(transmission_tint_)) return std::nullopt;
    sample.wi = refract_at_plane(wo, eta_o / eta_t, cos_t);
    sample.weight = transmission_tint_ * ((1 - fresnel) / p * squared_index_factor(mode, eta_o, eta_t, policy));
    set_delta_pdfs(sample, wo, p, p, eta_o, eta_t);
    sample.transmission = true;
    sample.radiance_scale = squared(eta_o / eta_t);
    return sample;
}

}  // namespace etendue
