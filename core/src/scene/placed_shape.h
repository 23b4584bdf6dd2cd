#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <etendue/requirements.h>
#include <etendue/scene_description.h>

#include "accel/embree_accel.h"
#include "math/rgb.h"

namespace etendue {

class KnownGeometry;

/// All that geometry in place depends on. Keeps no description alive.
struct Placement {
    std::weak_ptr<const GeometryDesc> geometry;
    Matrix4 parent_from_object;
    bool as_mesh = false;
    CoordinateUse coordinates = CoordinateUse::Unused;
};

/// A shape ready to be traced, in world space or in its group's.
struct PlacedShape {
    std::string name;
    std::optional<Placement> placement;              ///< empty: a light's own shape
    std::shared_ptr<const PlacedGeometry> geometry;  ///< its address is given to the accelerator
    std::vector<int> materials;                      ///< by slot
    std::vector<int> lights;                         ///< by slot, -1: none; empty: none at all (instanced: see Scene)
};

/// Checks and places one shape, relative to `origin` in its parent. `as_mesh` asks for triangles even where an exact
/// surface exists. `coordinates` is by geometry. Takes over what is known. Throws SceneError naming the shape.
[[nodiscard]] PlacedShape place_shape(const ShapeDesc& shape, const SceneDescription& scene, bool as_mesh,
                                      const std::vector<CoordinateUse>& coordinates, const KnownGeometry& known,
                                      const Vec3& origin = {});

/// Whether any slot's material emits.
[[nodiscard]] bool is_emissive(const ShapeDesc& shape, const SceneDescription& scene);

}  // namespace etendue
