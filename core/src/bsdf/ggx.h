#pragma once

#include <algorithm>
#include <cmath>

#include "math/constants.h"
#include "math/vec.h"

namespace etendue {

/// Below this alpha a lobe is a delta. It is then 2e-5 rad wide, 1/25 of a pixel of a 60 degree, 1920 pixel wide view,
/// and only a hundred times wider than the noise in directions between points that were hit in float (1e-7), so that
/// its density could no longer be evaluated alike by all strategies.
inline constexpr double kSmoothAlpha = 1e-5;

/// Isotropic GGX microfacets with Smith's height-correlated masking-shadowing (Heitz 2014), local frame, upper side.
/// Everything is written with a(w) = sqrt(cos^2 + alpha^2 sin^2) = cos (1 + 2 Lambda), which neither cancels at small
/// alpha nor divides by a cosine at grazing angles.
class Ggx {
public:
    explicit Ggx(double alpha) : alpha_(alpha) {}

    [[nodiscard]] double a(const Vec3& w) const {
        return std::sqrt(w.z * w.z + alpha_ * alpha_ * (w.x * w.x + w.y * w.y));
    }

    /// Distribution of normals D(h / |h|), per solid angle; h need not be unit. sin^2 is taken from x and y, never as
    /// 1 - cos^2.
    [[nodiscard]] double d(const Vec3& h) const {
        const double alpha2 = alpha_ * alpha_;
        const double ratio = length_squared(h) / (h.x * h.x + h.y * h.y + alpha2 * h.z * h.z);
        return alpha2 * ratio * ratio / kPi;
    }

    /// G2 / (cos_o cos_i) = 1 / (1 + Lambda_o + Lambda_i) / (cos_o cos_i), from absolute cosines and their a().
    [[nodiscard]] static double g2_over_cosines(double cos_o, double a_o, double cos_i, double a_i) {
        return 2 / (cos_o * a_i + cos_i * a_o);
    }

    /// G1 / cos: the density of visible normals is D |w . m| times this (Heitz 2014 eq. 2).
    [[nodiscard]] static double g1_over_cos(double cos_w, double a_w) { return 2 / (cos_w + a_w); }

    /// A normal visible from w, w.z > 0: in the space where the surface is a hemisphere, visible normals halve the
    /// angle between w and a uniform point of the cap above the plane z = -w.z (Dupuy and Benyoub 2023).
    [[nodiscard]] Vec3 sample_visible(const Vec3& w, const Vec2& u) const {
        const Vec3 v = normalize({alpha_ * w.x, alpha_ * w.y, w.z});
        const double depth = u.x * (1 + v.z);  // of the point below the pole
        const double r = std::sqrt(std::max(0.0, depth * (2 - depth)));
        const double phi = 2 * kPi * u.y;
        // The point's z plus v.z is (1 - u)(1 + v.z), positive without a difference.
        const Vec3 h{r * std::cos(phi) + v.x, r * std::sin(phi) + v.y, (1 - u.x) * (1 + v.z)};
        return normalize({alpha_ * h.x, alpha_ * h.y, h.z});
    }

private:
    double alpha_;
};

}  // namespace etendue
