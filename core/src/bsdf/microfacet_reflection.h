#pragma once

#include <cmath>

#include "bsdf/ggx.h"

namespace etendue {

/// Reflection off GGX microfacets without its Fresnel factor; wo and wi on the same side, either one.
struct MicrofacetReflection {
    double value = 0;    ///< D G2 / (4 cos_o cos_i) (Walter 2007 eq. 20)
    double pdf_fwd = 0;  ///< of wi given wo when visible normals are sampled: D G1 / (4 cos_o)
    double pdf_rev = 0;  ///< of wo given wi
    double cos_m = 0;    ///< to the facet, for the Fresnel factor

    MicrofacetReflection(const Ggx& ggx, const Vec3& wo, const Vec3& wi) {
        const Vec3 h = wo + wi;
        const double d_quarter = ggx.d(h) / 4;
        const double cos_o = std::abs(wo.z);
        const double cos_i = std::abs(wi.z);
        const double a_o = ggx.a(wo);
        const double a_i = ggx.a(wi);
        value = d_quarter * Ggx::g2_over_cosines(cos_o, a_o, cos_i, a_i);
        pdf_fwd = d_quarter * Ggx::g1_over_cos(cos_o, a_o);
        pdf_rev = d_quarter * Ggx::g1_over_cos(cos_i, a_i);
        cos_m = length(h) / 2;  // |wo + wi| = 2 cos
    }
};

/// Direction with which visible-normal sampling continues; on the wrong side of the surface when the facet's reflection
/// is masked.
inline Vec3 sample_microfacet_reflection(const Ggx& ggx, const Vec3& wo, const Vec2& u) {
    const Vec3 up{wo.x, wo.y, std::abs(wo.z)};
    const Vec3 m = ggx.sample_visible(up, u);
    Vec3 wi = m * (2 * dot(up, m)) - up;
    if (wo.z < 0) wi.z = -wi.z;
    return wi;
}

}  // namespace etendue
