#include "geometry/triangle_mesh.h"

#include <cmath>

#include <etendue/error.h>

#include "geometry/ray.h"
#include "geometry/triangulate.h"

namespace etendue {
namespace {

[[noreturn]] void fail(const std::string& name, const std::string& what) { throw SceneError(name + ": " + what); }

void check_topology(const MeshDesc& mesh, const std::string& name) {
    if (mesh.points.empty() || mesh.face_vertex_counts.empty()) fail(name, "mesh is empty");
    std::size_t corners = 0;
    for (std::int32_t count : mesh.face_vertex_counts) {
        if (count < 3) fail(name, "a face has " + std::to_string(count) + " vertices, not 3 or more");
        corners += static_cast<std::size_t>(count);
    }
    if (corners != mesh.face_vertex_indices.size()) {
        fail(name, "faceVertexCounts add up to " + std::to_string(corners) + ", but there are " +
                       std::to_string(mesh.face_vertex_indices.size()) + " faceVertexIndices");
    }
    const auto points = static_cast<std::int32_t>(mesh.points.size());
    for (std::int32_t index : mesh.face_vertex_indices) {
        if (index < 0 || index >= points) {
            fail(name, "faceVertexIndices holds " + std::to_string(index) + ", but there are " +
                           std::to_string(points) + " points");
        }
    }
    if (!mesh.face_materials.empty() && mesh.face_materials.size() != mesh.face_vertex_counts.size()) {
        fail(name, "face materials do not match the number of faces");
    }
}

std::size_t primvar_size(const MeshDesc& mesh, Interpolation interpolation) {
    switch (interpolation) {
        case Interpolation::Constant:
            return 1;
        case Interpolation::Uniform:
            return mesh.face_vertex_counts.size();
        case Interpolation::Vertex:
            return mesh.points.size();
        case Interpolation::FaceVarying:
            return mesh.face_vertex_indices.size();
    }
    return 0;
}

void check_primvar(const MeshDesc& mesh, std::size_t size, Interpolation interpolation, const std::string& name,
                   const char* what) {
    const std::size_t expected = primvar_size(mesh, interpolation);
    if (size != 0 && size != expected) {
        fail(name, std::string(what) + " has " + std::to_string(size) + " values where " + std::to_string(expected) +
                       " are needed");
    }
}

template <typename Array>
void check_finite(const std::vector<Array>& values, const std::string& name, const char* what) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (float value : values[i]) {
            if (!std::isfinite(value)) fail(name, std::string(what) + "[" + std::to_string(i) + "] is not finite");
        }
    }
}

/// A corner of a triangle: which face, which vertex, which place in the face-vertex list.
struct Corner {
    std::uint32_t face;
    std::uint32_t vertex;
    std::uint32_t face_vertex;
};

std::uint32_t primvar_index(const Corner& corner, Interpolation interpolation) {
    switch (interpolation) {
        case Interpolation::Constant:
            return 0;
        case Interpolation::Uniform:
            return corner.face;
        case Interpolation::Vertex:
            return corner.vertex;
        case Interpolation::FaceVarying:
            return corner.face_vertex;
    }
    return 0;
}

Float3 to_float3(const Vec3& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

void place_points(const MeshDesc& desc, const Transform& parent_from_object, const std::string& name,
                  TriangleMesh& mesh) {
    mesh.points.reserve(desc.points.size() + 1);
    for (const Float3& p : desc.points) mesh.points.push_back(to_float3(parent_from_object.point(Vec3{p})));
    for (const Float3& p : mesh.points) {
        if (!within_reach(Vec3{p})) fail(name, "points are not finite, or too far away, after the transform");
    }
    mesh.points.push_back({});
}

void place_normals(const MeshDesc& desc, const Transform& parent_from_object, TriangleMesh& mesh) {
    mesh.normals.reserve(desc.normals.size());
    for (const Float3& n : desc.normals) {
        const Vec3 placed = parent_from_object.normal(Vec3{n});
        const double size = length(placed);
        mesh.normals.push_back(size > 0 ? to_float3(placed / size) : Float3{});
    }
}

/// Cuts faces and hands over each triangle's corners.
class FaceCutter {
public:
    explicit FaceCutter(const MeshDesc& desc) : desc_(desc) {}

    template <typename Visit>
    void run(const Visit& visit) {
        std::uint32_t first = 0;
        for (std::uint32_t face = 0; face < desc_.face_vertex_counts.size(); ++face) {
            const auto count = static_cast<std::uint32_t>(desc_.face_vertex_counts[face]);
            cut(first, count);
            for (const std::array<int, 3>& t : triangles_) {
                visit(face,
                      std::array{corner(face, first, t[0]), corner(face, first, t[1]), corner(face, first, t[2])});
            }
            first += count;
        }
    }

private:
    void cut(std::uint32_t first, std::uint32_t count) {
        corners_.clear();
        triangles_.clear();
        for (std::uint32_t i = 0; i < count; ++i) corners_.emplace_back(desc_.points[vertex(first + i)]);
        triangulate_polygon(corners_, triangles_);
    }
    [[nodiscard]] std::uint32_t vertex(std::uint32_t face_vertex) const {
        return static_cast<std::uint32_t>(desc_.face_vertex_indices[face_vertex]);
    }
    [[nodiscard]] Corner corner(std::uint32_t face, std::uint32_t first, int i) const {
        const std::uint32_t face_vertex = first + static_cast<std::uint32_t>(i);
        return {face, vertex(face_vertex), face_vertex};
    }

    const MeshDesc& desc_;
    std::vector<Vec3> corners_;
    std::vector<std::array<int, 3>> triangles_;
};

/// Room for all triangles at once: growing arrays would take twice that, and copy.
void reserve_triangles(const MeshDesc& desc, bool own_normals, bool own_st, TriangleMesh& mesh) {
    const std::size_t count = desc.face_vertex_indices.size() - 2 * desc.face_vertex_counts.size();
    mesh.triangles.reserve(count);
    if (own_normals) mesh.normal_indices.reserve(count);
    if (own_st) mesh.st_indices.reserve(count);
    if (!desc.face_materials.empty()) mesh.material_slots.reserve(count);
}

void cut_faces(const MeshDesc& desc, TriangleMesh& mesh) {
    const bool own_normals = !desc.normals.empty() && desc.normals_interpolation != Interpolation::Vertex;
    const bool own_st = !mesh.st.empty() && desc.st_interpolation != Interpolation::Vertex;
    const auto indices = [](const std::array<Corner, 3>& c, Interpolation interpolation) {
        return TriangleIndices{primvar_index(c[0], interpolation), primvar_index(c[1], interpolation),
                               primvar_index(c[2], interpolation)};
    };
    reserve_triangles(desc, own_normals, own_st, mesh);
    FaceCutter(desc).run([&](std::uint32_t face, const std::array<Corner, 3>& c) {
        mesh.triangles.push_back({c[0].vertex, c[1].vertex, c[2].vertex});
        if (own_normals) mesh.normal_indices.push_back(indices(c, desc.normals_interpolation));
        if (own_st) mesh.st_indices.push_back(indices(c, desc.st_interpolation));
        if (!desc.face_materials.empty()) mesh.material_slots.push_back(desc.face_materials[face]);
    });
}

}  // namespace

std::size_t TriangleMesh::memory_used() const {
    const auto bytes = [](const auto& array) { return array.capacity() * sizeof(array[0]); };
    return bytes(points) + bytes(triangles) + bytes(normals) + bytes(normal_indices) + bytes(st) + bytes(st_indices) +
           bytes(material_slots);
}

TriangleMesh make_triangle_mesh(const MeshDesc& desc, const Transform& parent_from_object, const std::string& name,
                                CoordinateUse coordinates) {
    check_topology(desc, name);
    check_finite(desc.points, name, "points");
    check_finite(desc.normals, name, "normals");
    check_primvar(desc, desc.normals.size(), desc.normals_interpolation, name, "normals");

    TriangleMesh mesh;
    place_points(desc, parent_from_object, name, mesh);
    place_normals(desc, parent_from_object, mesh);
    if (coordinates != CoordinateUse::Unused) {
        check_finite(desc.st, name, "texture coordinates");
        check_primvar(desc, desc.st.size(), desc.st_interpolation, name, "texture coordinates");
        mesh.st = desc.st;
        mesh.has_tangents = coordinates == CoordinateUse::Tangents;
    }
    mesh.outward = desc.left_handed != parent_from_object.flips_handedness() ? -1 : 1;
    cut_faces(desc, mesh);
    return mesh;
}

}  // namespace etendue
