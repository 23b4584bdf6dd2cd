#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <etendue/requirements.h>
#include <etendue/scene_description.h>

#include "math/transform.h"
#include "math/vec.h"

namespace etendue {

using TriangleIndices = std::array<std::uint32_t, 3>;

/// Triangles in the space in which Embree sees them: the world, or an instanced group's space.
struct TriangleMesh {
    /// One more than there are: Embree loads 16 bytes at each vertex.
    std::vector<Float3> points;
    std::vector<TriangleIndices> triangles;
    std::vector<Float3> normals;                  ///< empty: faceted
    std::vector<TriangleIndices> normal_indices;  ///< empty: as `triangles`
    std::vector<Float2> st;                       ///< empty: none, or nobody asks for them
    std::vector<TriangleIndices> st_indices;      ///< empty: as `triangles`
    std::vector<std::int32_t> material_slots;     ///< per triangle; empty: all 0
    /// -1 when the winding gives the inward normal (left-handed, or mirrored by the transform, but not both).
    double outward = 1;
    bool has_tangents = false;  ///< whether anybody asks for the directions of st

    [[nodiscard]] bool operator==(const TriangleMesh&) const = default;

    /// Bytes of all its arrays.
    [[nodiscard]] std::size_t memory_used() const;
    [[nodiscard]] std::size_t point_count() const { return points.size() - 1; }
    [[nodiscard]] Vec3 point(std::size_t triangle, std::size_t corner) const {
        return Vec3{points[triangles[triangle][corner]]};
    }
    [[nodiscard]] int material_slot(std::size_t triangle) const {
        return material_slots.empty() ? 0 : material_slots[triangle];
    }
    [[nodiscard]] Float2 corner_st(std::size_t triangle, std::size_t corner) const {
        return st[(st_indices.empty() ? triangles : st_indices)[triangle][corner]];
    }
    [[nodiscard]] Vec3 corner_normal(std::size_t triangle, std::size_t corner) const {
        return Vec3{normals[(normal_indices.empty() ? triangles : normal_indices)[triangle][corner]]};
    }
};

/// Checks the mesh, cuts its faces into triangles and places it. Texture coordinates that nobody asks for are not
/// looked at. Throws SceneError naming `name`.
[[nodiscard]] TriangleMesh make_triangle_mesh(const MeshDesc& desc, const Transform& parent_from_object,
                                              const std::string& name,
                                              CoordinateUse coordinates = CoordinateUse::Tangents);

}  // namespace etendue
