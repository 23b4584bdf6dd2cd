#pragma once

#include <optional>

#include <etendue/scene_description.h>

#include "bsdf/adjoint.h"
#include "bsdf/bsdf_sample.h"

namespace etendue {

/// Phong's highlight cos^n about the mirror direction, on whichever side wo is (theory.md §7; Veach 5.2.1). Without a
/// cosine ("modified") it is symmetric:
///   f = reflectance (n + 2) / (2 pi) cos^n a.
/// The classic form divides by the cosine of the direction that light comes from, and is not:
///   f = reflectance (n + 1) / (2 pi) cos^n a / |cos|.
/// Seen along the normal either has the albedo `reflectance`, and less elsewhere, where the lobe dips below the
/// surface. Particles may gain energy at the classic form: they arrive at small cosines and leave at large ones.
class Phong {
public:
    Phong(const Rgb& reflectance, double exponent, PhongForm form)
        : reflectance_(reflectance), exponent_(exponent), form_(form) {}

    [[nodiscard]] Rgb eval(const Vec3& wo, const Vec3& wi, TransportMode mode, const AdjointPolicy& policy) const;
    [[nodiscard]] double pdf(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(const Vec3& wo, double u_lobe, const Vec2& u, TransportMode mode,
                                                   const AdjointPolicy& policy) const;

    [[nodiscard]] bool has_delta() const { return false; }
    [[nodiscard]] bool has_non_delta() const { return true; }

private:
    [[nodiscard]] double lobe(const Vec3& wo, const Vec3& wi) const;

    Rgb reflectance_;
    double exponent_;
    PhongForm form_;
};

}  // namespace etendue
