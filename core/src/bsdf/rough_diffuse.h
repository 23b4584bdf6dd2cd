#pragma once

#include <optional>

#include "bsdf/adjoint.h"
#include "bsdf/bsdf_sample.h"

namespace etendue {

/// Oren-Nayar in its energy-preserving form ("EON", Portsmouth, Kutz and Hill 2024), on whichever side wo is: Fujii's
/// single scattering, and what the facets shade returned by a symmetric lobe, so that white reflects everything at any
/// roughness in [0, 1]. Roughness 0 is Lambert; Diffuse is that for less.
class RoughDiffuse {
public:
    RoughDiffuse(const Rgb& reflectance, double roughness) : reflectance_(reflectance), roughness_(roughness) {}

    [[nodiscard]] Rgb eval(const Vec3& wo, const Vec3& wi, TransportMode mode, const AdjointPolicy& policy) const;
    [[nodiscard]] double pdf(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(const Vec3& wo, double u_lobe, const Vec2& u, TransportMode mode,
                                                   const AdjointPolicy& policy) const;

    [[nodiscard]] bool has_delta() const { return false; }
    [[nodiscard]] bool has_non_delta() const { return true; }

    /// The part of it that is a Lambert lobe: f is never less than reflectance times this over pi.
    [[nodiscard]] static double lambert_part(double roughness);
    /// For wi on wo's side of the surface, like all that follow.
    [[nodiscard]] static Rgb f(const Rgb& reflectance, double roughness, const Vec3& wo, const Vec3& wi);
    [[nodiscard]] static double pdf(double roughness, const Vec3& wo, const Vec3& wi);
    [[nodiscard]] static Vec3 sample_direction(double roughness, const Vec3& wo, double u_lobe, const Vec2& u);

private:
    Rgb reflectance_;
    double roughness_;
};

}  // namespace etendue
