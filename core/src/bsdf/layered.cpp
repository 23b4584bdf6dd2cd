#include "bsdf/layered.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bsdf/microfacet_reflection.h"
#include "bsdf/rough_diffuse.h"
#include "bsdf/specular_albedo.h"
#include "math/frame.h"
#include "math/sampling.h"

namespace etendue {
namespace {

/// A coat that lets through less than this hides its base.
constexpr double kOpaqueCoat = 1e-6;

double base_scale(double diffuse, double mean_transmittance) {
    return mean_transmittance > kOpaqueCoat ? diffuse / mean_transmittance : 0;
}

/// Mean of (1 - E)^2.
Rgb mean_squared_transmittance(double alpha, const Rgb& f0, const Rgb& f90) {
    return Rgb(1) - mean_specular_albedo(alpha)(f0, f90) * 2 + mean_squared_specular_albedo(alpha)(f0, f90);
}

/// 1 - E_mean of all that lies over the diffuse base, or more.
Rgb mean_transmittance(const LayeredParameters& p) {
    if (p.clearcoat.f90 == 0) return Rgb(1) - mean_specular_albedo(p.alpha)(p.coat_f0, p.coat_f90);
    const Clearcoat& top = p.clearcoat;
    const Rgb squares = mean_squared_transmittance(p.alpha, p.coat_f0, p.coat_f90) *
                        mean_squared_transmittance(top.alpha, Rgb(top.f0), Rgb(top.f90));
    return {std::sqrt(squares.r), std::sqrt(squares.g), std::sqrt(squares.b)};
}

}  // namespace

Layered::Layered(const LayeredParameters& parameters) : p_(parameters) {
    const Rgb mean = mean_transmittance(p_);
    base_scale_ = {base_scale(p_.diffuse.r, mean.r), base_scale(p_.diffuse.g, mean.g),
                   base_scale(p_.diffuse.b, mean.b)};
}

bool Layered::has_delta() const {
    const bool mirror = smooth() && p_.metal + p_.coated + p_.veil > 0;
    return p_.presence < 1 || mirror || (has_clearcoat() && clearcoat_is_smooth()) || p_.veil > 0 ||
           (p_.glass > 0 && p_.glass_model.has_delta());
}

bool Layered::has_non_delta() const {
    if (!(p_.presence > 0)) return false;
    const bool rough = !smooth() && p_.metal + p_.coated + p_.veil > 0;
    const bool diffuse = p_.coated > 0 && !is_black(base_scale_);
    const bool clearcoat = has_clearcoat() && !clearcoat_is_smooth();
    return rough || diffuse || clearcoat || (p_.glass > 0 && p_.glass_model.has_non_delta());
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

/// Fresnel factor of the clearcoat's lobe.
double Layered::clearcoat_weight(double cos_m, bool outside) const {
    const double s5 = pow5(std::max(0.0, 1 - cos_m));
    return clearcoat_share(outside) * std::lerp(p_.clearcoat.f0, p_.clearcoat.f90, s5);
}

/// E_c.
double Layered::clearcoat_albedo(double cos) const {
    const Clearcoat& top = p_.clearcoat;
    const SpecularAlbedo albedo = specular_albedo(cos, top.alpha);
    return albedo.of_f0 * top.f0 + albedo.of_f90 * top.f90;
}

/// T_c: never more than what the clearcoat leaves.
double Layered::clearcoat_transmittance(double cos) const {
    const double margin = specular_albedo_margin(cos, p_.clearcoat.alpha) * p_.clearcoat.f90;
    return std::max(0.0, 1 - clearcoat_albedo(cos) - margin);
}

/// What a clearcoat on both sides leaves of the metal and the coat.
double Layered::under_clearcoat(const Vec3& wo, const Vec3& wi) const {
    if (!has_clearcoat()) return 1;
    return std::min(clearcoat_transmittance(std::abs(wo.z)), clearcoat_transmittance(std::abs(wi.z)));
}

/// What a clearcoat outside leaves of the glass.
double Layered::glass_under_clearcoat(const Vec3& wo, const Vec3& wi) const {
    if (!has_clearcoat()) return 1;
    const auto one = [this](const Vec3& w) { return w.z > 0 ? clearcoat_transmittance(w.z) : 1; };
    return std::min(one(wo), one(wi));
}

/// T T_c: never more than what the coats leave.
Rgb Layered::base_transmittance(double cos) const {
    const Rgb albedo = specular_albedo(cos, p_.alpha)(p_.coat_f0, p_.coat_f90);
    const double margin = specular_albedo_margin(cos, p_.alpha);
    const double above = has_clearcoat() ? clearcoat_transmittance(cos) : 1;
    const auto rest = [margin, above](double e) { return std::max(0.0, 1 - e - margin) * above; };
    return {rest(albedo.r), rest(albedo.g), rest(albedo.b)};
}

/// f of the diffuse base as seen through the coats.
Rgb Layered::base(const Vec3& wo, const Vec3& wi) const {
    const Rgb t_o = base_transmittance(std::abs(wo.z));
    const Rgb t_i = base_transmittance(std::abs(wi.z));
    const Rgb lambert = base_scale_ * t_o * t_i * kInvPi;
    const double roughness = p_.diffuse_roughness;
    if (roughness == 0) return lambert;
    const double part = RoughDiffuse::lambert_part(roughness);
    const Rgb rest = RoughDiffuse::f(p_.diffuse, roughness, wo, wi) - p_.diffuse * (part * kInvPi);
    // Not negative, but for rounding.
    const auto through = [](double f, double a, double b) { return std::max(0.0, f) * std::min(a, b); };
    return lambert * part +
           Rgb(through(rest.r, t_o.r, t_i.r), through(rest.g, t_o.g, t_i.g), through(rest.b, t_o.b, t_i.b));
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
    if (has_multiple_scattering()) {
        const Rgb reflectance = MultipleScattering(p_.alpha).reflectance(p_.metal_fresnel);
        const double below = has_clearcoat() ? clearcoat_transmittance(cos) : 1;
        p.diffuse += p_.metal * max_component(reflectance) * lost_albedo(cos, p_.alpha) * below;
    }
    if (p_.veil > 0) p.veil = outside ? p_.veil * max_component(base_transmittance(cos)) : p_.veil;
    p.glass = p_.glass;
    if (has_clearcoat()) {
        const double below = clearcoat_transmittance(cos);
        p.clearcoat = clearcoat_share(outside) * clearcoat_albedo(cos);
        p.specular *= below;
        if (outside) p.glass *= below;
    }
    const double sum = p.clearcoat + p.specular + p.diffuse + p.veil + p.glass;
    // A denormal sum has no reciprocal; what reflects so little is black in any picture.
    const double scale = sum >= std::numeric_limits<double>::min() ? p_.presence / sum : 0;
    p.clearcoat *= scale;
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
            f += specular_weight(facet.cos_m, wo.z > 0) * (facet.value * under_clearcoat(wo, wi));
        }
        if (has_clearcoat() && !clearcoat_is_smooth()) {
            const MicrofacetReflection facet(Ggx(p_.clearcoat.alpha), wo, wi);
            f += Rgb(clearcoat_weight(facet.cos_m, wo.z > 0) * facet.value);
        }
        if (has_multiple_scattering()) {
            const MultipleScattering multiple(p_.alpha);
            const double value = multiple.value(std::abs(wo.z), std::abs(wi.z)) * under_clearcoat(wo, wi);
            f += multiple.reflectance(p_.metal_fresnel) * (value * p_.metal);
        }
        if (p_.coated > 0) f += base(wo, wi) * p_.coated;
    }
    if (p_.glass > 0) f += p_.glass_model.eval(wo, wi, mode, policy) * (p_.glass * glass_under_clearcoat(wo, wi));
    return f * p_.presence;
}

double Layered::pdf(const LobeProbabilities& p, const Vec3& wo, const Vec3& wi) const {
    double pdf = 0;
    if (wo.z * wi.z > 0) {
        if (!smooth()) pdf += p.specular * MicrofacetReflection(Ggx(p_.alpha), wo, wi).pdf_fwd;
        if (has_clearcoat() && !clearcoat_is_smooth()) {
            pdf += p.clearcoat * MicrofacetReflection(Ggx(p_.clearcoat.alpha), wo, wi).pdf_fwd;
        }
        pdf += p.diffuse * RoughDiffuse::pdf(p_.diffuse_roughness, wo, wi);
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
    if (rest < p.clearcoat) {
        if (!clearcoat_is_smooth()) return sample_reflection(p, Ggx(p_.clearcoat.alpha), wo, u, mode, policy);
        return sample_mirror(wo, Rgb(clearcoat_weight(std::abs(wo.z), wo.z > 0)), p.clearcoat);
    }
    rest -= p.clearcoat;
    if (rest < p.specular) {
        const double cos = std::abs(wo.z);
        if (smooth()) return sample_mirror(wo, specular_weight(cos, wo.z > 0) * under_clearcoat(wo, wo), p.specular);
        return sample_reflection(p, Ggx(p_.alpha), wo, u, mode, policy);
    }
    rest -= p.specular;
    if (rest < p.diffuse) {
        const Vec3 wi = RoughDiffuse::sample_direction(p_.diffuse_roughness, wo, rest / p.diffuse, u);
        return finish(p, wo, wi, mode, policy);
    }
    rest -= p.diffuse;
    if (rest < p.veil) return sample_veil(p, wo, rest / p.veil, mode, policy);
    rest -= p.veil;
    if (!(p.glass > 0)) return std::nullopt;
    return sample_glass(p, wo, std::clamp(rest / p.glass, 0.0, kOneMinusEpsilon), u, mode, policy);
}

/// A direction from a non-delta lobe, weighed with all of them.
Layered::Sample Layered::finish(const LobeProbabilities& p, const Vec3& wo, const Vec3& wi, TransportMode mode,
                                const AdjointPolicy& policy) const {
    const double pdf_fwd = pdf(p, wo, wi);
    if (!(pdf_fwd >= kLeastPdf)) return std::nullopt;
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

Layered::Sample Layered::sample_mirror(const Vec3& wo, const Rgb& albedo, double probability) const {
    BsdfSample sample;
    sample.wi = {-wo.x, -wo.y, wo.z};
    sample.weight = albedo * (p_.presence / probability);
    set_delta_pdfs(sample, wo, probability, probability, eta(wo), eta(wo));
    return sample;
}

Layered::Sample Layered::sample_reflection(const LobeProbabilities& p, const Ggx& ggx, const Vec3& wo, const Vec2& u,
                                           TransportMode mode, const AdjointPolicy& policy) const {
    const Vec3 wi = sample_microfacet_reflection(ggx, wo, u);
    if (!(wo.z * wi.z > 0)) return std::nullopt;  // masked, though glass may well send light there
    return finish(p, wo, wi, mode, policy);
}

Layered::Sample Layered::sample_glass(const LobeProbabilities& p, const Vec3& wo, double u_lobe, const Vec2& u,
                                      TransportMode mode, const AdjointPolicy& policy) const {
    Sample sample = p_.glass_model.sample(wo, u_lobe, u, mode, policy);
    if (!sample) return std::nullopt;
    if (!sample->delta) return finish(p, wo, sample->wi, mode, policy);
    sample->weight *= p_.presence * p_.glass * glass_under_clearcoat(wo, sample->wi) / p.glass;
    sample->pdf_fwd *= p.glass;
    sample->pdf_rev *= probabilities(sample->wi).glass;
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
