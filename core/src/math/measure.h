#pragma once

#include <cmath>

#include "math/vec.h"

namespace etendue {

/// The only conversions between densities per solid angle (pdf_w) and per area (pdf_a). The normal is always the
/// GEOMETRIC normal of the surface on which the area lies: area is geometry, and shading normals are part of the BSDF
/// (theory.md §6).

/// pdf_a = pdf_w * |cos| / d^2 for the point `to` on a surface of normal `n_g_to`, seen from `from`.
inline double area_per_solid_angle(const Vec3& from, const Vec3& to, const Vec3& n_g_to) {
    const Vec3 d = to - from;
    const double d2 = length_squared(d);
    return abs_dot(d, n_g_to) / (d2 * std::sqrt(d2));
}

/// False for a point whose own plane `from` lies in, or the very same point: no light gets from there to there, and
/// weights would be 0/0. Embree knows the planes of needles so badly that rays which leave them hit them again.
inline bool arrives(const Vec3& from, const Vec3& to, const Vec3& n_g_to) { return abs_dot(to - from, n_g_to) > 0; }

}  // namespace etendue
