#pragma once

#include "geometry/ray.h"
#include "math/vec.h"

namespace etendue {

/// LightPoint::p_error of a point whose exact terms add up to `magnitude` per axis (Transform::magnitude). The ray
/// tracer holds the same surface in float: each factor of each term and each of the sums that make up a point rounds
/// by at most kFloatRounding of the magnitude, which is six roundings for p' = M p + t; eight leave room for the ray
/// itself.
inline Vec3 float_point_error(const Vec3& magnitude) { return magnitude * (8 * kFloatRounding); }

/// The same on a parallelogram that reaches `extent` around the point. Embree intersects flat faces relative to their
/// corners, so its error has a part that follows their size along every axis: a light in a coordinate plane would else
/// get no distance from itself.
inline Vec3 flat_point_error(const Vec3& magnitude, double extent) {
    return float_point_error(magnitude + Vec3(extent, extent, extent));
}

}  // namespace etendue
