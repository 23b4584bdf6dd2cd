#pragma once

#include <cstddef>
#include <vector>

#include <etendue/scene_description.h>

#include "math/vec.h"

namespace etendue {

/// The points from which the render measures positions, in the world and in each group's space. Embree and meshes hold
/// positions in float, whose steps are 1/16 at a million: a scene that lies farther from the world's origin than it is
/// large would lose digits that its authored points and matrices have. The point is next to the scene, on a grid of a
/// power of two that is at least twice as wide as the scene: what lies about the world's origin stays there, and a
/// scene moved by whole steps of its grid is rendered alike bit for bit. Surfaces alone decide it, where there are any:
/// who moves the camera or a lamp shall not have to place all of them anew. Far from them, either is far from the point
/// as well, and is known no worse than its distance to them. Shapes may lie as far off within what instances share, and
/// the instances back.
struct Origins {
    Vec3 world{};
    std::vector<Vec3> groups;  ///< those that are missing are 0

    [[nodiscard]] Vec3 of_group(std::size_t group) const { return group < groups.size() ? groups[group] : Vec3{}; }
};

/// Descriptions that are refused elsewhere may give anything.
[[nodiscard]] Origins find_origins(const SceneDescription& scene, const CameraDesc& camera);

/// The same placement, seen from `origin`: the difference of the translations is taken in double.
[[nodiscard]] Matrix4 relative_to(const Vec3& origin, Matrix4 world_from_object);

/// The same placement, of what is measured from `origin` in its own space; in double.
[[nodiscard]] Matrix4 measured_from(const Vec3& origin, Matrix4 world_from_object);

}  // namespace etendue
