#pragma once

#include "math/vec.h"
#include "scene/scene.h"

namespace etendue {

/// p itself, or beside it where p lies in a surface as far as float can tell, a camera in the plane of the water: then
/// on the surface's outer side. Of rays that start in a surface some find it and some do not, and no medium would be
/// the right one for all of them.
[[nodiscard]] Vec3 off_surfaces(const Scene& scene, const Vec3& p);

}  // namespace etendue
