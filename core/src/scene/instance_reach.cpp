#include "scene/instance_reach.h"

#include <cmath>
#include <limits>

#include "geometry/ray.h"

namespace etendue {
namespace {

/// Embree inverts an instance's matrix in float: a determinant that overflows there would make the inverse 0, and of
/// rays in the group points without a direction.
bool inverts_in_float(const Transform& transform) {
    const Vec3 rows = transform.vector_magnitude({1, 1, 1});
    return rows.x * rows.y * rows.z <= std::numeric_limits<float>::max() &&
           std::abs(transform.determinant()) >= std::numeric_limits<float>::min();
}

}  // namespace

bool takes_rays_from(const SceneBounds& bounds, const Transform& world_from_group) {
    const double farthest = max_component(abs(bounds.center)) + bounds.radius;
    const Transform group_from_world = world_from_group.inverse();
    return inverts_in_float(world_from_group) &&
           within_reach(group_from_world.magnitude({farthest, farthest, farthest})) &&
           within_reach(group_from_world.vector_magnitude({1, 1, 1})) &&
           within_reach(world_from_group.vector_magnitude({1, 1, 1})) && within_reach(world_from_group.translation());
}

}  // namespace etendue
