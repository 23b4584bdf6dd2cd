#pragma once

#include <algorithm>
#include <cmath>

#include "math/vec.h"

namespace etendue {

/// How far Embree's plane of a triangle may lie from the true one, along any axis, in kFloatRounding of how far the
/// triangle reaches. `twice_area` is |e1 x e2|.
///
/// Embree takes the normal for the cross product of two edges, in float: the roundings of its terms, |e1||e2|, stay
/// where the terms cancel. It takes edges whose product is small, so that needles with a short one do no harm. Where
/// all three are long, the plane is turned, and ends lie off it by |e1||e2| / |e1 x e2| roundings: half of such a
/// triangle's width where it is a few thousand times as long as wide. A ray that starts nearer may be stopped by the
/// triangle it leaves; surfaces of such triangles came out up to 80 % too dark. A quarter of the bound sufficed for all
/// that were tried. At most it is a quarter of the triangle's length.
inline double plane_roundings(const Vec3& e1, const Vec3& e2, double twice_area) {
    constexpr double kAny = 8;
    constexpr double kMost = 0x1p22;
    const double tame = kAny * twice_area;
    const double a = length_squared(e1);
    const double b = length_squared(e2);
    if (a * b <= tame * tame) return kAny;  // nearly all triangles
    const double c = length_squared(e2 - e1);
    const double terms = std::min({a * b, b * c, c * a});
    if (terms <= tame * tame) return kAny;
    return std::min(std::sqrt(terms) / twice_area, kMost);
}

}  // namespace etendue
