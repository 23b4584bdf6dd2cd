#include "scene/light_triangles.h"

#include <utility>

#include "geometry/plane_roundings.h"
#include "geometry/ray.h"

namespace etendue {
namespace {

/// As Embree has the triangle, in the mesh's own space.
double plane_error(const TriangleMesh& mesh, std::size_t triangle) {
    const Vec3 e1 = mesh.point(triangle, 1) - mesh.point(triangle, 0);
    const Vec3 e2 = mesh.point(triangle, 2) - mesh.point(triangle, 0);
    const double extent = max_component(max(max(abs(e1), abs(e2)), abs(e2 - e1)));
    return extent * plane_roundings(e1, e2, length(cross(e1, e2))) * kFloatRounding;
}

}  // namespace

std::vector<LightTriangle> light_triangles(const TriangleMesh& mesh, int slot, const Transform& world_from_parent) {
    const bool reversed = (mesh.outward < 0) != world_from_parent.flips_handedness();
    std::vector<LightTriangle> out;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (slot >= 0 && mesh.material_slot(t) != slot) continue;
        LightTriangle triangle;
        const double error = plane_error(mesh, t);
        triangle.plane_error = world_from_parent.vector_magnitude({error, error, error});
        for (std::size_t corner = 0; corner < 3; ++corner) {
            triangle.p[corner] = world_from_parent.point(mesh.point(t, corner));
            if (mesh.st.empty()) continue;
            const Float2 st = mesh.corner_st(t, corner);
            triangle.st[corner] = {st[0], st[1]};
        }
        if (reversed) {
            std::swap(triangle.p[1], triangle.p[2]);
            std::swap(triangle.st[1], triangle.st[2]);
        }
        out.push_back(triangle);
    }
    return out;
}

}  // namespace etendue
