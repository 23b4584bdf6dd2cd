#pragma once

#include <optional>

#include "bsdf/adjoint.h"
#include "bsdf/bsdf_sample.h"
#include "bsdf/ggx.h"

namespace etendue {

/// A pane: a slab of a dielectric that is too thin to shift light, both sides alike, its internal reflections summed
/// up. With the Fresnel reflectance R of one face, R' = R + (1 - R)^2 R / (1 - R^2) = 2R / (1 + R) is reflected and 1 -
/// R' goes on in the same direction, unscaled, for it leaves the slab again (theory.md §5).
///
/// Rough panes reflect by GGX with Schlick's curve through R' at normal incidence. What that leaves, T = 1 - E, goes
/// through with the facets of both faces bending it by (ior - 1)(m1 - m2), which blurs it like a mirror image off
/// facets of alpha |ior - 1| / sqrt(2): GGX once more, mirrored to the other side, times min(T(wo), T(wi)), which is
/// symmetric and conserves energy.
class ThinDielectric {
public:
    ThinDielectric(double ior, double alpha, const Rgb& reflection_tint, const Rgb& transmission_tint);

    [[nodiscard]] Rgb eval(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] double pdf(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(const Vec3& wo, double u_lobe, const Vec2& u) const;

    [[nodiscard]] bool has_delta() const { return transmission_alpha_ < kSmoothAlpha; }
    [[nodiscard]] bool has_non_delta() const { return alpha_ >= kSmoothAlpha; }

private:
    [[nodiscard]] double transmittance(double cos) const;
    [[nodiscard]] double reflection_probability(double cos) const;
    [[nodiscard]] std::optional<BsdfSample> sample_straight(const Vec3& wo, double p) const;
    [[nodiscard]] BsdfSample sample_mirror(const Vec3& wo, double p) const;

    double ior_;
    double alpha_;
    double transmission_alpha_;
    double f0_;
    double f90_;
    Rgb reflection_tint_;
    Rgb transmission_tint_;
};

}  // namespace etendue
