#include "bsdf/layered.h"

#include <algorithm>
#include <cmath>

#include "bsdf/microfacet_reflection.h"
#include "bsdf/specular_albedo.h"
#include "math/sampling.h"

namespace etendue {
namespace {

/// A coat that lets through less than this hides its base.
constexpr double kOpaqueCoat = 1e-6;

Vec3 flip(const Vec3& w) { return {w.x, w.y, -w.z}; }

double base_scale(double diffuse, double mean_transmittance) {
    return mean_transmittance > kOpaqueCoat ? diffuse / mean_transmittance : 0;
}

}  // namespace

Layered::Layered(const LayeredParameters& parameters) : p_(parameters) {
    const Rgb mean = Rgb(1) - mean_specular_albedo(p_.alpha)(p_.coat_f0, p_.coat_f90);
    base_scale_ = {base_scale(p_.diffuse.r, mean.r), base_scale(p_.diffuse.g, mean.g),
                   base_scale(p_.diffuse.b, mean.b)};
}

bool Layered::has_delta() const {
    const bool mirror = smooth() && p_.metal + p_.coated + p_.veil > 0;
    return p_.presence < 1 || mirror || p_.veil > 0 || (p_.glass > 0 && p_.glass_model.has_delta());
}

bool Layered::has_non_delta() const {
    if (!(p_.presence > 0)) return false;
    const bool rough = !smooth() && p_.metal + p_.coated + p_.veil > 0;
    const bool diffuse = p_.coated > 0 && !is_black(base_scale_);
    return rough || diffuse || (p_.glass > 0 && p_.glass_model.has_non_delta());
}

double Layered::eta(const Vec3& w) const {
    if (p_.glass > 0) return p_.glass_model.eta(w);
    return w.z > 0 || p_.veil == 0 ? 1 : p_.veil_ior;
}

/// Fresnel factor of all reflections that share the GGX lobe.
Rgb Layered::specular_weight(double cos_m, bool outside) const {
    const double coat = p_.coated + (outside ? p_.veil : 0);
    const SchlickFresnel coat_fresnel{p_.coat_f0, p_.coat_f90, Rgb()};
    return p_.metal_fresnel(cos_m) * p_.metal + p_.coat_tint * coat_fresnel(cos_m) * coat;
}

/// T: never more than what the coat leaves.
Rgb Layered::base_transmittance(double cos) const {
    const Rgb albedo = specular_albedo(cos, p_.alpha)(p_.coat_f0, p_.coat_f90);
    const double margin = specular_albedo_margin(cos, p_.alpha);
    const auto rest = [margin](double e) { return std::max(0.0, 1 - e - margin); };
    return {rest(albedo.r), rest(albedo.g), rest(albedo.b)};
}

/// Proportional to each lobe's albedo, so that samples carry nearly equal weights; the hole's is exact.
Layered::LobeProbabilities Layered::probabilities(const Vec3& wo) const {
    const double cos = std::abs(wo.z);
    const bool outside = wo.z > 0;
    const SpecularAlbedo albedo = specular_albedo(cos, p_.alpha);
    const double coat = p_.coated + (outside ? p_.veil : 0);
    const Rgb specular = albedo(p_.metal_fresnel.f0, p_.metal_fresnel.f90) * p_.metal +
                         p_.coat_tint * albedo(p_.coat_f0, p_.coat_f90) * coat;
    LobeProbabilities p;
    p.specular = max_component(specular);
    if (p_.coated > 0) p.diffuse = p_.coated * max_component(p_.diffuse * base_transmittance(cos));
    if (p_.veil > 0) p.veil = outside ? p_.veil * max_component(base_transmittance(cos)) : p_.veil;
    p.glass = p_.glass;
    const double sum = p.specular + p.diffuse + p.veil + p.glass;
    const double scale = sum > 0 ? p_.presence / sum : 0;
    p.specular *= scale;
    p.diffuse *= scale;
    p.veil *= scale;
    p.glass *= scale;
    p.hole = 1 - p_.presence;
    return p;
}

Rgb Layered::eval(const Vec3& wo, const Vec3& wi, TransportMode mode, const AdjointPolicy& policy) const {
    Rgb f;
    if (wo.z * wi.z > 0) {
        if (!smooth()) {
            const MicrofacetReflection facet(Ggx(p_.alpha), wo, wi);
            f += specular_weight(facet.cos_m, wo.z > 0) * facet.value;
        }
        if (p_.coated > 0) {
            f += base_scale_ * base_transmittance(std::abs(wo.z)) * base_transmittance(std::abs(wi.z)) *
                 (p_.coated * kInvPi);
        }
    }
    if (p_.glass > 0) f += p_.glass_model.eval(wo, wi, mode, policy) * p_.glass;
    return f * p_.presence;
}

double Layered::pdf(const LobeProbabilities& p, const Vec3& wo, const Vec3& wi) const {
    double pdf = 0;
    if (wo.z * wi.z > 0) {
        if (!smooth()) pdf += p.specular * MicrofacetReflection(Ggx(p_.alpha), wo, wi).pdf_fwd;
        pdf += p.diffuse * std::abs(wi.z) * kInvPi;
    }
    if (p.glass > 0) pdf += p.glass * p_.glass_model.pdf(wo, wi);
    return pdf;
}

double Layered::pdf(const Vec3& wo, const Vec3& wi) const { return pdf(probabilities(wo), wo, wi); }

std::optional<BsdfSample> Layered::sample(const Vec3& wo, double u_lobe, const Vec2& u, TransportMode mode,
                                          const AdjointPolicy& policy) const {
    if (wo.z == 0) return std::nullopt;
    const LobeProbabilities p = probabilities(wo);
    double rest = u_lobe;
    if (rest < p.hole) return sample_hole(p, wo);
    rest -= p.hole;
    if (rest < p.specular) {
        if (smooth()) return sample_mirror(p, wo);
        return finish(p, wo, sample_microfacet_reflection(Ggx(p_.alpha), wo, u), mode, policy);
    }
    rest -= p.specular;
    if (rest < p.diffuse) {
        Vec3 wi = sample_cosine_hemisphere(u);
        if (wo.z < 0) wi = flip(wi);
        return finish(p, wo, wi, mode, policy);
    }
    rest -= p.diffuse;
    if (rest < p.veil) return sample_veil(p, wo, rest / p.veil, mode, policy);
    rest -= p.veil;
    if (!(p.glass > 0)) return std::nullopt;

    const double u_glass = std::clamp(rest / p.glass, 0.0, kOneMinusEpsilon);
    Sample sample = p_.glass_model.sample(wo, u_glass, u, mode, policy);
    if (!sample) return std::nullopt;
    if (!sample->delta) return finish(p, wo, sample->wi, mode, policy);
    sample->weight *= p_.presence * p_.glass / p.glass;
    sample->pdf_fwd *= p.glass;
    sample->pdf_rev *= probabilities(sample->wi).glass;
    return sample;
}

/// A direction from a non-delta lobe, weighed with all of them.
Layered::Sample Layered::finish(const LobeProbabilities& p, const Vec3& wo, const Vec3& wi, TransportMode mode,
                                const AdjointPolicy& policy) const {
    const double pdf_fwd = pdf(p, wo, wi);
    if (!(pdf_fwd > 0)) return std::nullopt;
    BsdfSample sample;
    sample.wi = wi;
    sample.weight = eval(wo, wi, mode, policy) * (std::abs(wi.z) / pdf_fwd);
    sample.pdf_fwd = pdf_fwd;
    sample.pdf_rev = pdf(wi, wo);
    sample.transmission = wo.z * wi.z < 0;
    const double ratio = eta(wo) / eta(wi);
    sample.radiance_scale = ratio * ratio;
    return sample;
}

Layered::Sample Layered::sample_hole(const LobeProbabilities& p, const Vec3& wo) const {
    BsdfSample sample;
    sample.wi = -wo;
    sample.weight = Rgb(1);
    sample.transmission = true;
    set_delta_pdfs(sample, wo, p.hole, p.hole, 1, 1);
    return sample;
}

Layered::Sample Layered::sample_mirror(const LobeProbabilities& p, const Vec3& wo) const {
    BsdfSample sample;
    sample.wi = {-wo.x, -wo.y, wo.z};
    sample.weight = specular_weight(std::abs(wo.z), wo.z > 0) * (p_.presence / p.specular);
    set_delta_pdfs(sample, wo, p.specular, p.specular, eta(wo), eta(wo));
    return sample;
}

Layered::Sample Layered::sample_veil(const LobeProbabilities& p, const Vec3& wo, double u, TransportMode mode,
                                     const AdjointPolicy& policy) const {
    const bool outside = wo.z > 0;
    const double eta_o = eta(wo);
    const double eta_t = eta(flip(wo));
    const double cos_o = std::abs(wo.z);
    const double cos_t = eta_o == eta_t ? cos_o : refracted_cos(cos_o, eta_t / eta_o);
    const Rgb transmittance = cos_t > 0 ? base_transmittance(outside ? cos_o : cos_t) : Rgb();
    // From inside one lobe both reflects and refracts.
    const double p_refraction = outside ? 1 : max_component(transmittance);
    BsdfSample sample;
    const double weight = p_.presence * p_.veil / p.veil;
    if (u >= p_refraction) {
        sample.wi = {-wo.x, -wo.y, wo.z};
        sample.weight = (Rgb(1) - transmittance) * (weight / (1 - p_refraction));
        set_delta_pdfs(sample, wo, p.veil * (1 - p_refraction), p.veil * (1 - p_refraction), eta_o, eta_o);
        return sample;
    }
    if (!(cos_t > 0)) return std::nullopt;
    sample.wi = refract_at_plane(wo, eta_o / eta_t, cos_t);
    sample.weight = transmittance * (weight / p_refraction * squared_index_factor(mode, eta_o, eta_t, policy));
    const double p_back = probabilities(sample.wi).veil * (outside ? max_component(transmittance) : 1);
    set_delta_pdfs(sample, wo, p.veil * p_refraction, p_back, eta_o, eta_t);
    sample.transmission = true;
    sample.radiance_scale = (eta_o / eta_t) * (eta_o / eta_t);
    return sample;
}

}  // namespace etendue
