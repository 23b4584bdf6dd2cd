#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"
#include "light/mesh_light.h"
#include "math/transform.h"

namespace etendue {

/// The triangles of one material slot (all when negative) in world space, wound so that the front is outward.
[[nodiscard]] std::vector<LightTriangle> light_triangles(const TriangleMesh& mesh, int slot,
                                                         const Transform& world_from_parent);

}  // namespace etendue
