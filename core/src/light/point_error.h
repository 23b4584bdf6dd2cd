#pragma once

#include "geometry/ray.h"
#include "math/vec.h"

namespace etendue {

/// LightPoint::p_error of a point whose exact terms add up to `magnitude` per axis (Transform::magnitude). The ray
/// tracer holds the same surface in float: each factor of each term and each of the sums that make up a point rounds
/// by at most kFloatRounding of the magnitude, which is six roundings for p' = M p + t; eight leave room for the ray
/// itself.
inline Vec3 float_point_error(const Vec3& magnitude) { return magnitude * (8 * kFloatRounding); }

}  // namespace etendue
