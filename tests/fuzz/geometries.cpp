#include "fuzz/geometries.h"

#include <algorithm>

#include "fuzz/placements.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

Float3 random_corner(Dice& dice) {
    const Vec3 p = random_point(dice, 1);
    return {static_cast<float>(dice.number(p.x)), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// One square, seen from +z.
MeshDesc square() {
    MeshDesc mesh;
    mesh.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.face_vertex_counts = {4};
    mesh.face_vertex_indices = {0, 1, 2, 3};
    return mesh;
}

/// Triangles anywhere, some of them needles, without area, or twice there.
MeshDesc soup(Dice& dice) {
    MeshDesc mesh;
    const int faces = dice.whole(1, 8);
    for (int face = 0; face < faces; ++face) {
        const auto first = static_cast<std::int32_t>(mesh.points.size());
        for (int i = 0; i < 3; ++i) mesh.points.push_back(random_corner(dice));
        const auto a = static_cast<std::size_t>(first);
        if (dice.chance(0.15))
            mesh.points[a + 1][0] = mesh.points[a][0] + static_cast<float>(dice.log_between(1e-9, 1));
        if (dice.chance(0.1)) mesh.points[a + 2] = mesh.points[a];
        if (dice.chance(0.05)) mesh.points[a + 1] = mesh.points[a + 2] = mesh.points[a];
        const int times = dice.chance(0.1) ? 2 : 1;
        for (int i = 0; i < times; ++i) {
            mesh.face_vertex_counts.push_back(3);
            mesh.face_vertex_indices.insert(mesh.face_vertex_indices.end(), {first, first + 1, first + 2});
        }
    }
    return mesh;
}

/// One face, concave, and often crossing itself.
MeshDesc polygon(Dice& dice) {
    MeshDesc mesh;
    const int corners = dice.whole(3, 12);
    for (int i = 0; i < corners; ++i) {
        mesh.points.push_back(random_corner(dice));
        if (dice.chance(0.9)) mesh.points.back()[2] = 0;
        mesh.face_vertex_indices.push_back(dice.chance(0.05) ? dice.below(i + 1) : i);
    }
    mesh.face_vertex_counts = {corners};
    return mesh;
}

MeshDesc plain_mesh(Dice& dice) {
    switch (dice.below(5)) {
        case 0:
            return square();
        case 1:
            return low_polygon_sphere(dice.whole(3, 8), dice.whole(2, 6), false);
        case 2:
            return low_polygon_sphere(dice.whole(3, 8), dice.whole(2, 6), true);
        case 3:
            return soup(dice);
        default:
            return polygon(dice);
    }
}

std::size_t count(const MeshDesc& mesh, Interpolation interpolation) {
    if (interpolation == Interpolation::Constant) return 1;
    if (interpolation == Interpolation::Uniform) return mesh.face_vertex_counts.size();
    if (interpolation == Interpolation::Vertex) return mesh.points.size();
    return mesh.face_vertex_indices.size();
}

Interpolation random_interpolation(Dice& dice) {
    return dice.one_of(
        {Interpolation::Constant, Interpolation::Uniform, Interpolation::Vertex, Interpolation::FaceVarying});
}

void add_normals(Dice& dice, MeshDesc& mesh) {
    mesh.normals_interpolation = random_interpolation(dice);
    mesh.normals.resize(count(mesh, mesh.normals_interpolation));
    const double size = dice.chance(0.2) ? dice.log_between(1e-20, 1e18) : 1;
    for (Float3& normal : mesh.normals) {
        if (dice.chance(0.05)) continue;
        const Vec3 n = random_point(dice, 1) * size;
        normal = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(dice.number(n.z))};
    }
}

void add_st(Dice& dice, MeshDesc& mesh) {
    mesh.st_interpolation = random_interpolation(dice);
    mesh.st.resize(count(mesh, mesh.st_interpolation));
    const double size = dice.chance(0.2) ? dice.log_between(1e-20, 1e20) : 1;
    for (Float2& st : mesh.st) {
        const double s = dice.between(-size, 2 * size);
        st = {static_cast<float>(s), static_cast<float>(dice.number(dice.between(-size, 2 * size)))};
    }
}

void spoil(Dice& dice, MeshDesc& mesh) {
    switch (dice.below(6)) {
        case 0:
            mesh.face_vertex_indices[0] = dice.one_of({-1, static_cast<int>(mesh.points.size()), 1 << 30});
            break;
        case 1:
            mesh.face_vertex_counts[0] = dice.one_of({0, -1, 2, 1 << 30});
            break;
        case 2:
            mesh.points.clear();
            break;
        case 3:
            mesh = {};
            break;
        case 4:
            mesh.normals.resize(mesh.points.size() + 1, {0, 0, 1});
            break;
        default:
            mesh.face_materials.assign(mesh.face_vertex_counts.size(), dice.one_of({-1, 7, 1 << 30}));
            break;
    }
}

MeshDesc random_mesh(Dice& dice) {
    MeshDesc mesh = plain_mesh(dice);
    if (dice.chance(0.25)) add_normals(dice, mesh);
    if (dice.chance(0.4)) add_st(dice, mesh);
    mesh.left_handed = dice.chance(0.2);
    if (dice.chance(0.003)) spoil(dice, mesh);
    return mesh;
}

}  // namespace

GeometryDesc random_geometry(Dice& dice) {
    const auto size = [&] { return dice.number(dice.chance(0.05) ? dice.log_between(1e-6, 1e6) : 1); };
    const Axis axis = dice.one_of({Axis::X, Axis::Y, Axis::Z});
    switch (dice.below(10)) {
        case 0:
        case 1:
            return SphereDesc{size()};
        case 2:
            return CubeDesc{size()};
        case 3:
            return CylinderDesc{size(), size(), axis};
        case 4:
            return ConeDesc{size(), size(), axis};
        case 5:
            return CapsuleDesc{size(), dice.chance(0.1) ? 0 : size(), axis};
        case 6:
            return PlaneDesc{size(), size(), axis};
        default:
            return random_mesh(dice);
    }
}

}  // namespace etendue::test
