#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include <etendue/scene_description.h>

#include "geometry/quadric.h"
#include "geometry/triangle_mesh.h"
#include "light/emission_texture.h"
#include "light/light.h"
#include "light/mesh_light.h"

namespace etendue {

/// What is traced for a light, world space. Its outward geometric normal is that of the emitting side.
using LightShape = std::variant<TriangleMesh, Quadric>;

/// All three throw SceneError naming the light when its attributes have no meaning: not finite, negative sizes or
/// intensity, a singular transform, normalised without an area.

/// Geometry to be traced for the light; none for points, infinite lights, lights without area, and mesh lights (their
/// mesh is a shape of the scene). Needs no scene bounds, since it is part of them.
[[nodiscard]] std::optional<LightShape> make_light_shape(const LightDesc& light);

/// Any light but a mesh light. `bounds` must enclose all that can be hit; only infinite lights use it. `image` is the
/// light's texture, which must outlive it (lux_texture); null: none.
[[nodiscard]] std::unique_ptr<Light> make_light(const LightDesc& light, const SceneBounds& bounds,
                                                std::shared_ptr<const EmissionImage> image = nullptr);

/// A light whose emitting geometry is a mesh of the scene. `tint` is the glow of the mesh's material for
/// LightDesc::tinted_by_material, else null. `whole_area` is that of all the mesh where the triangles are a part of it.
[[nodiscard]] std::unique_ptr<Light> make_mesh_light(const LightDesc& light, std::vector<LightTriangle> triangles,
                                                     std::shared_ptr<const EmissionTexture> tint,
                                                     std::optional<double> whole_area = {});

}  // namespace etendue
