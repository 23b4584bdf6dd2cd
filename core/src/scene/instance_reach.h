#pragma once

#include "light/light.h"
#include "math/transform.h"

namespace etendue {

/// Embree takes rays from anywhere in the scene into the group, directions and all.
[[nodiscard]] bool takes_rays_from(const SceneBounds& bounds, const Transform& world_from_group);

}  // namespace etendue
