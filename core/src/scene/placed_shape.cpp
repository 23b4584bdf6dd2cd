#include "scene/placed_shape.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include <etendue/error.h>

#include "geometry/ray.h"
#include "geometry/tessellate.h"
#include "scene/known_geometry.h"
#include "scene/requirements.h"
#include "scene/world_origin.h"

namespace etendue {
namespace {

void check_indices(const ShapeDesc& shape, const SceneDescription& scene) {
    if (shape.geometry < 0 || shape.geometry >= static_cast<int>(scene.geometries.size())) {
        throw SceneError(shape.name + ": geometry index " + std::to_string(shape.geometry) + " is out of range");
    }
    if (shape.materials.empty()) throw SceneError(shape.name + ": shape has no material");
    for (int material : shape.materials) {
        if (material < 0 || material >= static_cast<int>(scene.materials.size())) {
            throw SceneError(shape.name + ": material index " + std::to_string(material) + " is out of range");
        }
    }
}

void check_slots(const TriangleMesh& mesh, const ShapeDesc& shape) {
    const auto slots = static_cast<int>(shape.materials.size());
    for (int slot : mesh.material_slots) {
        if (slot < 0 || slot >= slots) {
            throw SceneError(shape.name + ": face material " + std::to_string(slot) + " is out of range");
        }
    }
}

void check_size(double size, const char* what, const std::string& name) {
    if (!(size > 0) || !std::isfinite(size)) throw SceneError(name + ": " + what + " must be positive");
}

/// USD's sizes are lengths: what is negative or not finite has no meaning to guess at.
void check_sizes(const SphereDesc& sphere, const std::string& name) { check_size(sphere.radius, "radius", name); }
void check_sizes(const CubeDesc& cube, const std::string& name) { check_size(cube.size, "size", name); }
void check_sizes(const PlaneDesc& plane, const std::string& name) {
    check_size(plane.width, "width", name);
    check_size(plane.length, "length", name);
}
template <typename Revolved>
void check_sizes(const Revolved& body, const std::string& name) {
    check_size(body.radius, "radius", name);
    // A capsule of no height is a sphere.
    if (std::is_same_v<Revolved, CapsuleDesc> && body.height == 0) return;
    check_size(body.height, "height", name);
}

void check_reach(const Quadric& quadric, const std::string& name) {
    const Quadric::Bounds bounds = quadric.bounds();
    if (!within_reach(bounds.lower) || !within_reach(bounds.upper))
        throw SceneError(name + ": it reaches too far away");
}

PlacedGeometry place_geometry(const GeometryDesc& desc, const Transform& parent_from_object, const std::string& name,
                              bool as_mesh, CoordinateUse coordinates) {
    return std::visit(
        [&](const auto& geometry) -> PlacedGeometry {
            using Kind = std::decay_t<decltype(geometry)>;
            if constexpr (std::is_same_v<Kind, MeshDesc>) {
                return make_triangle_mesh(geometry, parent_from_object, name, coordinates);
            } else {
                check_sizes(geometry, name);
                if constexpr (std::is_same_v<Kind, SphereDesc>) {
                    if (!as_mesh) {
                        const Quadric sphere{QuadricKind::Sphere,
                                             geometry.radius,
                                             false,
                                             parent_from_object,
                                             0,
                                             coordinates != CoordinateUse::Unused};
                        check_reach(sphere, name);
                        return sphere;
                    }
                }
                return make_triangle_mesh(tessellate(geometry), parent_from_object, name, coordinates);
            }
        },
        desc);
}

Transform transform_of(const ShapeDesc& shape, const Matrix4& parent_from_object) {
    try {
        return Transform(parent_from_object);
    } catch (const SceneError& error) {
        throw SceneError(shape.name + ": " + error.what());
    }
}

}  // namespace

bool is_emissive(const ShapeDesc& shape, const SceneDescription& scene) {
    return std::any_of(shape.materials.begin(), shape.materials.end(), [&](int material) {
        return is_emissive(scene.materials.at(static_cast<std::size_t>(material)));
    });
}

PlacedShape place_shape(const ShapeDesc& shape, const SceneDescription& scene, bool as_mesh,
                        const std::vector<CoordinateUse>& coordinates, const KnownGeometry& known, const Vec3& origin) {
    check_indices(shape, scene);
    const SharedGeometry& geometry = scene.geometries[static_cast<std::size_t>(shape.geometry)];
    const bool triangles = as_mesh || is_emissive(shape, scene);
    const Placement placement{geometry.pointer(), relative_to(origin, shape.parent_from_object), triangles,
                              coordinates[static_cast<std::size_t>(shape.geometry)]};
    PlacedShape placed;
    placed.name = shape.name;
    placed.materials = shape.materials;
    placed.placement = placement;
    placed.geometry = known.find(placement);
    if (!placed.geometry) {
        placed.geometry = std::make_shared<const PlacedGeometry>(
            place_geometry(*geometry, transform_of(shape, placement.parent_from_object), shape.name, triangles,
                           placement.coordinates));
    }
    if (const auto* mesh = std::get_if<TriangleMesh>(placed.geometry.get())) check_slots(*mesh, shape);
    return placed;
}

}  // namespace etendue
