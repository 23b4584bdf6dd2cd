#pragma once

#include <etendue/scene_description.h>

#include "math/vec.h"

namespace etendue {

/// The point from which the render measures positions. Embree and meshes hold positions in float, whose steps are 1/16
/// at a million: a scene that lies farther from the world's origin than it is large would lose digits that its
/// authored points and matrices have. The point is next to the scene, on a grid of a power of two that is at least
/// twice as wide as the scene: what lies about the world's origin stays there, and a scene moved by whole steps of its
/// grid is rendered alike bit for bit. Descriptions that are refused elsewhere may give anything.
[[nodiscard]] Vec3 world_origin(const SceneDescription& scene, const CameraDesc& camera);

/// The same placement, seen from `origin`: the difference of the translations is taken in double.
[[nodiscard]] Matrix4 relative_to(const Vec3& origin, Matrix4 world_from_object);

}  // namespace etendue
