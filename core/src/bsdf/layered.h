#pragma once

#include <optional>

#include "bsdf/adjoint.h"
#include "bsdf/bsdf_sample.h"
#include "bsdf/dielectric.h"
#include "bsdf/fresnel.h"
#include "bsdf/ggx.h"
#include "bsdf/multiple_scattering.h"

namespace etendue {

/// A second, white coat over everything else; f0 and f90 are scaled by its amount. There is none when f90 is 0.
struct Clearcoat {
    double alpha = 0;
    double f0 = 0;
    double f90 = 0;
};

/// What a Layered is made of. metal + coated + veil + glass = 1.
struct LayeredParameters {
    double presence = 1;  ///< the rest is a hole: straight through
    double alpha = 0;     ///< of metal and coat
    double metal = 0;
    SchlickFresnel metal_fresnel;
    double coated = 0;  ///< diffuse base under the coat
    double veil = 0;    ///< nothing but the coat, and smooth refraction below it
    Rgb coat_f0;
    Rgb coat_f90;
    Rgb coat_tint{1};
    Rgb diffuse;
    double diffuse_roughness = 0;  ///< of RoughDiffuse; 0 is Lambert
    double veil_ior = 1.5;
    double glass = 0;
    Dielectric glass_model{1, 0};
    Clearcoat clearcoat;
};

/// The closure of UsdPreviewSurface and OpenPBR: a convex combination of components each of which is reciprocal and
/// conserves energy on both sides, so that their sum does.
///
///   metal   GGX reflection and MultipleScattering. Both sides alike.
///   coated  GGX reflection with Fresnel factor F over a diffuse base. Both sides alike. What the coat does not reflect
///           reaches the base: f = rho / pi T(wo) T(wi) / (1 - E_mean) with T = 1 - E, E the coat's directional albedo
///           (Kelemen and Szirmay-Kalos 2001). Symmetric, and its albedo is rho T(wo) or less. That is for the part of
///           a rough base that is Lambert; the rest is multiplied by min(T(wo), T(wi)), to the same effect.
///   veil    UsdPreviewSurface's transparent part: the same coat outside, smooth refraction below. It transmits T at
///           the outer cosine, from both sides; from inside, the rest is reflected by a mirror.
///   glass   a Dielectric.
///
/// A clearcoat lies over all of it: on both sides of metal and coated, outside of veil and glass. Below it the metal,
/// the coat and the glass are multiplied by min(T_c(wo), T_c(wi)), with T_c = 1 - E_c of the clearcoat: symmetric, at
/// most what the clearcoat lets through, and lossless over a mirror, where both are equal. Base and veil get T T_c in
/// place of T, and 1 - E_mean becomes the root of mean T^2 mean T_c^2, which is not less than the mean of T T_c
/// (Cauchy and Schwarz) and close to it, for both fall towards the same grazing angles.
///
/// A lobe's probability depends on wo alone (and is computed for wi where the reverse density is asked for).
class Layered {
public:
    explicit Layered(const LayeredParameters& parameters);

    [[nodiscard]] Rgb eval(const Vec3& wo, const Vec3& wi, TransportMode mode, const AdjointPolicy& policy) const;
    [[nodiscard]] double pdf(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(const Vec3& wo, double u_lobe, const Vec2& u, TransportMode mode,
                                                   const AdjointPolicy& policy) const;

    [[nodiscard]] bool has_delta() const;
    [[nodiscard]] bool has_non_delta() const;

private:
    struct LobeProbabilities {
        double hole = 0;
        double clearcoat = 0;
        double specular = 0;
        double diffuse = 0;  ///< and of the metal's multiple scattering
        double veil = 0;
        double glass = 0;
    };

    [[nodiscard]] bool smooth() const { return p_.alpha < kSmoothAlpha; }
    [[nodiscard]] bool has_clearcoat() const { return p_.clearcoat.f90 > 0; }
    [[nodiscard]] bool clearcoat_is_smooth() const { return p_.clearcoat.alpha < kSmoothAlpha; }
    /// Veil and glass have a clearcoat outside only.
    [[nodiscard]] double clearcoat_share(bool outside) const { return outside ? 1 : p_.metal + p_.coated; }
    [[nodiscard]] double clearcoat_albedo(double cos) const;
    [[nodiscard]] double clearcoat_weight(double cos_m, bool outside) const;
    [[nodiscard]] double clearcoat_transmittance(double cos) const;
    [[nodiscard]] double under_clearcoat(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] double glass_under_clearcoat(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] LobeProbabilities probabilities(const Vec3& wo) const;
    [[nodiscard]] Rgb specular_weight(double cos_m, bool outside) const;
    [[nodiscard]] Rgb base_transmittance(double cos) const;
    [[nodiscard]] bool has_multiple_scattering() const { return p_.metal > 0 && MultipleScattering(p_.alpha).exists(); }
    [[nodiscard]] Rgb base(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] double pdf(const LobeProbabilities& p, const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] double eta(const Vec3& w) const;

    using Sample = std::optional<BsdfSample>;
    [[nodiscard]] Sample sample_hole(const LobeProbabilities& p, const Vec3& wo) const;
    [[nodiscard]] Sample sample_mirror(const Vec3& wo, const Rgb& albedo, double probability) const;
    [[nodiscard]] Sample sample_reflection(const LobeProbabilities& p, const Ggx& ggx, const Vec3& wo, const Vec2& u,
                                           TransportMode mode, const AdjointPolicy& policy) const;
    [[nodiscard]] Sample sample_glass(const LobeProbabilities& p, const Vec3& wo, double u_lobe, const Vec2& u,
                                      TransportMode mode, const AdjointPolicy& policy) const;
    [[nodiscard]] Sample sample_veil(const LobeProbabilities& p, const Vec3& wo, double u, TransportMode mode,
                                     const AdjointPolicy& policy) const;
    [[nodiscard]] Sample finish(const LobeProbabilities& p, const Vec3& wo, const Vec3& wi, TransportMode mode,
                                const AdjointPolicy& policy) const;

    LayeredParameters p_;
    Rgb base_scale_;  ///< diffuse / (1 - E_mean)
};

}  // namespace etendue
