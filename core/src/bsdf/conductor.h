#pragma once

#include <optional>

#include "bsdf/adjoint.h"
#include "bsdf/bsdf_sample.h"
#include "bsdf/fresnel.h"
#include "bsdf/ggx.h"

namespace etendue {

/// Metal by its reflectance: GGX with MultipleScattering, or a mirror when alpha is below kSmoothAlpha. Reflects on
/// whichever side wo is.
class Conductor {
public:
    Conductor(const SchlickFresnel& fresnel, double alpha) : fresnel_(fresnel), alpha_(alpha) {}
    Conductor(const Rgb& normal_reflectance, double alpha) : Conductor({normal_reflectance, Rgb(1), Rgb()}, alpha) {}

    [[nodiscard]] Rgb eval(const Vec3& wo, const Vec3& wi, TransportMode mode, const AdjointPolicy& policy) const;
    [[nodiscard]] double pdf(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(const Vec3& wo, double u_lobe, const Vec2& u, TransportMode mode,
                                                   const AdjointPolicy& policy) const;

    [[nodiscard]] bool has_delta() const { return alpha_ < kSmoothAlpha; }
    [[nodiscard]] bool has_non_delta() const { return !has_delta(); }

private:
    struct Scattering {
        Rgb f;
        double pdf_fwd = 0;
        double pdf_rev = 0;
    };
    /// Of directions on the same side.
    [[nodiscard]] Scattering scattering(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] double multiple_probability(double cos) const;

    SchlickFresnel fresnel_;
    double alpha_;
};

}  // namespace etendue
