#pragma once

#include <array>
#include <span>
#include <vector>

#include "math/vec.h"

namespace etendue {

/// Cuts a polygon, convex or concave, roughly planar, into triangles; appends corner numbers. A polygon that has no
/// valid cut (it crosses itself) becomes a fan.
void triangulate_polygon(std::span<const Vec3> corners, std::vector<std::array<int, 3>>& triangles);

}  // namespace etendue
