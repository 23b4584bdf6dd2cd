#include "scene/light_triangles.h"

#include <utility>

namespace etendue {

std::vector<LightTriangle> light_triangles(const TriangleMesh& mesh, int slot, const Transform& world_from_parent) {
    const bool reversed = (mesh.outward < 0) != world_from_parent.flips_handedness();
    std::vector<LightTriangle> out;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (slot >= 0 && mesh.material_slot(t) != slot) continue;
        LightTriangle triangle;
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
