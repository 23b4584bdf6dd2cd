#pragma once

#include <cmath>
#include <optional>

#include "bsdf/adjoint.h"
#include "bsdf/bsdf_sample.h"
#include "bsdf/ggx.h"
#include "bsdf/thin_dielectric.h"

namespace etendue {

/// Interface between the outside (+z, index 1) and the inside (-z, index ior): GGX (Walter et al. 2007 with visible
/// normals), or smooth, then both lobes are deltas. Reflection and refraction are chosen by the Fresnel reflectance of
/// the facet, weighted by the tints. A rough interface of (nearly) matched indices is smooth as well: there the half
/// vector of refraction is no longer defined, and nothing is deflected. Thin-walled it is a ThinDielectric instead.
class Dielectric {
public:
    Dielectric(double ior, double alpha, const Rgb& reflection_tint = Rgb(1), const Rgb& transmission_tint = Rgb(1),
               bool thin_walled = false)
        : ior_(ior),
          alpha_(alpha),
          reflection_tint_(reflection_tint),
          transmission_tint_(transmission_tint),
          thin_walled_(thin_walled) {}

    [[nodiscard]] Rgb eval(const Vec3& wo, const Vec3& wi, TransportMode mode, const AdjointPolicy& policy) const;
    [[nodiscard]] double pdf(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(const Vec3& wo, double u_lobe, const Vec2& u, TransportMode mode,
                                                   const AdjointPolicy& policy) const;

    [[nodiscard]] bool has_delta() const { return thin_walled_ ? thin().has_delta() : smooth(); }
    [[nodiscard]] bool has_non_delta() const { return thin_walled_ ? thin().has_non_delta() : !smooth(); }

    /// Index on the side of the surface on which w lies.
    [[nodiscard]] double eta(const Vec3& w) const { return w.z > 0 || thin_walled_ ? 1 : ior_; }

private:
    /// Refraction turns a facet's slope into a deflection of about |ior - 1| times it. Below this the whole lobe is as
    /// narrow as one of alpha = kSmoothAlpha at the largest roughness.
    static constexpr double kMatchedIndices = 1e-5;
    [[nodiscard]] bool smooth() const { return alpha_ < kSmoothAlpha || std::abs(ior_ - 1) < kMatchedIndices; }

    [[nodiscard]] ThinDielectric thin() const { return {ior_, alpha_, reflection_tint_, transmission_tint_}; }

    /// One pair of directions: f as particles see it, without the squared-index factor, and both densities.
    struct Scattering {
        Rgb f;
        double pdf_fwd = 0;
        double pdf_rev = 0;
    };
    [[nodiscard]] Scattering reflection(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] Scattering refraction(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] Scattering scattering(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] double reflection_probability(double fresnel) const;
    [[nodiscard]] std::optional<BsdfSample> sample_smooth(const Vec3& wo, double u_lobe, TransportMode mode,
                                                          const AdjointPolicy& policy) const;

    double ior_;
    double alpha_;
    Rgb reflection_tint_;
    Rgb transmission_tint_;
    bool thin_walled_;
};

/// Direction refracted at a plane of normal +-z; eta is the index on wo's side over that beyond, cos_t the cosine
/// beyond. Exactly -wo for eta = 1.
inline Vec3 refract_at_plane(const Vec3& wo, double eta, double cos_t) {
    if (eta == 1) return -wo;
    return {-eta * wo.x, -eta * wo.y, -std::copysign(cos_t, wo.z)};
}

/// Fills in what a delta lobe reports as densities (theory.md §3, transport.md §1). An interface preserves eta^2
/// dsigma_perp: from eta_o sin_o = eta_i sin_i, squared and differentiated, eta_o^2 sin_o cos_o dtheta_o dphi =
/// eta_i^2 sin_i cos_i dtheta_i dphi. A lobe that is chosen with probability P and maps wo to wi one to one therefore
/// has density P with respect to that measure, in both directions, and per solid angle P eta^2 |cos|.
inline void set_delta_pdfs(BsdfSample& sample, const Vec3& wo, double p_fwd, double p_rev, double eta_o, double eta_i) {
    sample.delta = true;
    sample.pdf_fwd = p_fwd * eta_i * eta_i * std::abs(sample.wi.z);
    sample.pdf_rev = p_rev * eta_o * eta_o * std::abs(wo.z);
}

}  // namespace etendue
