#pragma once

#include <etendue/scene_description.h>

namespace etendue {

/// The UsdGeom implicits that are not traced exactly, as meshes: cube and plane faceted and exact; cylinder, cone and
/// capsule with 64 segments and smooth normals; a sphere, where a mesh of one is needed, with 64 x 32.
[[nodiscard]] MeshDesc tessellate(const SphereDesc& sphere);
[[nodiscard]] MeshDesc tessellate(const CubeDesc& cube);
[[nodiscard]] MeshDesc tessellate(const PlaneDesc& plane);
[[nodiscard]] MeshDesc tessellate(const CylinderDesc& cylinder);
[[nodiscard]] MeshDesc tessellate(const ConeDesc& cone);
[[nodiscard]] MeshDesc tessellate(const CapsuleDesc& capsule);

}  // namespace etendue
