#pragma once

#include "math/transform.h"

namespace etendue {

/// Exact area of the ellipsoid that `world_from_object` makes of the unit sphere.
[[nodiscard]] double ellipsoid_area(const Transform& world_from_object);

}  // namespace etendue
