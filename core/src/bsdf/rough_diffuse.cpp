#include "bsdf/rough_diffuse.h"

#include <algorithm>
#include <cmath>

#include "math/constants.h"
#include "math/sampling.h"

namespace etendue {
namespace {

/// Fujii's normalisation 1 / (1 + kShading r) makes the albedo of single scattering 1 at grazing angles, where it is
/// largest.
constexpr double kShading = 0.5 - 2 / (3 * kPi);
/// Mean albedo of single scattering: (1 + kMean r) / (1 + kShading r).
constexpr double kMean = 2.0 / 3 - 28 / (15 * kPi);

double lambert_scale(double roughness) { return 1 / (1 + kShading * roughness); }

/// 1 - E of white single scattering at this cosine is lambert_scale times roughness times this, exactly 0 at cos = 0.
double lost(double cos) {
    const double c = std::min(cos, 1.0);
    const double sin = std::sqrt((1 - c) * (1 + c));
    // (1 - sin^3) / cos, without the division.
    const double rest = c * (1 + sin + sin * sin) / (1 + sin);
    const double g = sin * (std::acos(c) - sin * c) + 2.0 / 3 * sin * (rest - 1);
    return std::max(0.0, kShading - g * kInvPi);
}

/// Albedo of all light scattered more than once, for a mean albedo of single scattering.
double multiple_reflectance(double reflectance, double mean) {
    return reflectance * reflectance * mean / (1 - reflectance * (1 - mean));
}

/// Cosine-weighted directions leave the lobe towards grazing light to chance; a share of uniform ones bounds a sample's
/// weight by 4, for the lobe is at most roughness sin_o times a constant.
double uniform_share(double roughness, const Vec3& wo) { return 0.5 * roughness * std::hypot(wo.x, wo.y); }

}  // namespace

double RoughDiffuse::lambert_part(double roughness) { return lambert_scale(roughness) * (1 - roughness); }

Rgb RoughDiffuse::f(const Rgb& reflectance, double roughness, const Vec3& wo, const Vec3& wi) {
    const double cos_o = std::abs(wo.z);
    const double cos_i = std::abs(wi.z);
    const double scale = lambert_scale(roughness);
    const double s = wo.x * wi.x + wo.y * wi.y;
    const double s_over_t = s > 0 ? s / std::max(cos_o, cos_i) : s;
    const double single = scale * (1 + roughness * s_over_t);
    const double multiple = scale * roughness * lost(cos_o) * lost(cos_i) / (kShading - kMean);
    const double mean = scale * (1 + kMean * roughness);
    const Rgb returned{multiple_reflectance(reflectance.r, mean), multiple_reflectance(reflectance.g, mean),
                       multiple_reflectance(reflectance.b, mean)};
    return (reflectance * single + returned * multiple) * kInvPi;
}

double RoughDiffuse::pdf(double roughness, const Vec3& wo, const Vec3& wi) {
    const double uniform = uniform_share(roughness, wo);
    return ((1 - uniform) * std::abs(wi.z) + uniform / 2) * kInvPi;
}

Vec3 RoughDiffuse::sample_direction(double roughness, const Vec3& wo, double u_lobe, const Vec2& u) {
    Vec3 wi = u_lobe < uniform_share(roughness, wo) ? sample_uniform_cone(u, 1) : sample_cosine_hemisphere(u);
    wi.z = std::copysign(wi.z, wo.z);
    return wi;
}

Rgb RoughDiffuse::eval(const Vec3& wo, const Vec3& wi, TransportMode, const AdjointPolicy&) const {
    return wo.z * wi.z > 0 ? f(reflectance_, roughness_, wo, wi) : Rgb();
}

double RoughDiffuse::pdf(const Vec3& wo, const Vec3& wi) const { return wo.z * wi.z > 0 ? pdf(roughness_, wo, wi) : 0; }

std::optional<BsdfSample> RoughDiffuse::sample(const Vec3& wo, double u_lobe, const Vec2& u, TransportMode,
                                               const AdjointPolicy&) const {
    BsdfSample sample;
    sample.wi = sample_direction(roughness_, wo, u_lobe, u);
    if (!(wo.z * sample.wi.z > 0) || is_black(reflectance_)) return std::nullopt;
    sample.pdf_fwd = pdf(roughness_, wo, sample.wi);
    sample.pdf_rev = pdf(roughness_, sample.wi, wo);
    sample.weight = f(reflectance_, roughness_, wo, sample.wi) * (std::abs(sample.wi.z) / sample.pdf_fwd);
    return sample;
}

}  // namespace etendue
