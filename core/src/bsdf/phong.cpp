#include "bsdf/phong.h"

#include <cmath>

#include "math/constants.h"
#include "math/frame.h"

namespace etendue {
namespace {

Vec3 mirrored(const Vec3& w) { return {-w.x, -w.y, w.z}; }

}  // namespace

/// cos^n of the angle between wi and wo's mirror image, the same when they change places.
double Phong::lobe(const Vec3& wo, const Vec3& wi) const {
    if (!(wo.z * wi.z > 0)) return 0;
    const double cos = dot(mirrored(wo), wi);
    return cos > 0 ? std::pow(cos, exponent_) : 0;
}

Rgb Phong::eval(const Vec3& wo, const Vec3& wi, TransportMode mode, const AdjointPolicy& policy) const {
    const Rgb f = reflectance_ * (lobe(wo, wi) / (2 * kPi));
    if (is_black(f)) return Rgb();
    if (form_ == PhongForm::Modified) return f * (exponent_ + 2);
    return f * ((exponent_ + 1) / phong_cosine(mode, std::abs(wo.z), std::abs(wi.z), policy));
}

double Phong::pdf(const Vec3& wo, const Vec3& wi) const { return (exponent_ + 1) / (2 * kPi) * lobe(wo, wi); }

std::optional<BsdfSample> Phong::sample(const Vec3& wo, double, const Vec2& u, TransportMode mode,
                                        const AdjointPolicy& policy) const {
    // cos = (1 - u)^(1 / (n + 1)); its sine from 1 - cos^2 without the difference.
    const double log_cos = std::log1p(-u.x) / (exponent_ + 1);
    const double sin = std::sqrt(-std::expm1(2 * log_cos));
    const double phi = 2 * kPi * u.y;
    const Vec3 about_mirror{sin * std::cos(phi), sin * std::sin(phi), std::exp(log_cos)};
    BsdfSample sample;
    sample.wi = Frame::from_normal(mirrored(wo)).to_world(about_mirror);
    sample.pdf_fwd = sample.pdf_rev = pdf(wo, sample.wi);
    if (!(sample.pdf_fwd > 0)) return std::nullopt;
    // f |cos| / pdf, in which the lobe cancels: it may be a denormal number.
    const double cos_i = std::abs(sample.wi.z);
    const double weight = form_ == PhongForm::Modified ? (exponent_ + 2) / (exponent_ + 1) * cos_i
                                                       : cos_i / phong_cosine(mode, std::abs(wo.z), cos_i, policy);
    sample.weight = reflectance_ * weight;
    return sample;
}

}  // namespace etendue
