#include "geometry/tessellate.h"

#include <map>

#include <gtest/gtest.h>

#include "geometry/triangle_mesh.h"
#include "math/constants.h"

namespace etendue::test {
namespace {

Vec3 area_vector(const TriangleMesh& mesh, std::size_t t) {
    return cross(mesh.point(t, 1) - mesh.point(t, 0), mesh.point(t, 2) - mesh.point(t, 0)) * 0.5;
}

/// Every edge between two points (by position) is walked once each way: no crack, and one orientation throughout.
void expect_closed(const TriangleMesh& mesh) {
    std::map<std::pair<Float3, Float3>, int> edges;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Float3 a = mesh.points[mesh.triangles[t][corner]];
            Float3 b = mesh.points[mesh.triangles[t][(corner + 1) % 3]];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                a[axis] += 0.0F;  // -0 and 0 are one place
                b[axis] += 0.0F;
            }
            if (a == b) continue;
            ++edges[{a, b}];
            --edges[{b, a}];
        }
    }
    for (const auto& [edge, balance] : edges) ASSERT_EQ(balance, 0);
}

double volume(const TriangleMesh& mesh) {
    double sum = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) sum += dot(mesh.point(t, 0), area_vector(mesh, t)) / 3;
    return sum;
}

void expect_extent(const TriangleMesh& mesh, const Vec3& half) {
    Vec3 lower{kInfinity, kInfinity, kInfinity};
    Vec3 upper = -lower;
    for (std::size_t i = 0; i < mesh.point_count(); ++i) {
        lower = min(lower, Vec3{mesh.points[i]});
        upper = max(upper, Vec3{mesh.points[i]});
    }
    // Exact but for the float that stores it.
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_FLOAT_EQ(static_cast<float>(lower[axis]), static_cast<float>(-half[axis]));
        EXPECT_FLOAT_EQ(static_cast<float>(upper[axis]), static_cast<float>(half[axis]));
    }
}

void expect_convex_outward(const TriangleMesh& mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 n = area_vector(mesh, t);
        if (length(n) < 1e-12) continue;
        // The body is convex and holds the origin.
        EXPECT_GT(dot(n, mesh.point(t, 0)), 0);
        if (mesh.normals.empty()) continue;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Vec3 n_s = mesh.corner_normal(t, corner);
            EXPECT_NEAR(length(n_s), 1, 1e-6);
            EXPECT_GT(dot(n_s, normalize(n)), 0.98);
        }
    }
}

Vec3 along(Axis axis, double length, double across) {
    switch (axis) {
        case Axis::X:
            return {length, across, across};
        case Axis::Y:
            return {across, length, across};
        case Axis::Z:
            break;
    }
    return {across, across, length};
}

template <typename Desc>
void expect_body(const Desc& desc, const Vec3& half, double expected_volume, double tolerance) {
    const TriangleMesh mesh = make_triangle_mesh(tessellate(desc), {}, "/body");
    expect_closed(mesh);
    expect_extent(mesh, half);
    expect_convex_outward(mesh);
    EXPECT_NEAR(volume(mesh) / expected_volume, 1, tolerance);
    EXPECT_EQ(mesh.outward, 1);
}

// A regular 64-gon is smaller than its circle by a factor of sin(x) / x, x = 2 pi / 64.
constexpr double kPolygon = 0.998394;

TEST(Tessellate, CubesAreExact) {
    expect_body(CubeDesc{3}, {1.5, 1.5, 1.5}, 27, 1e-6);
    EXPECT_TRUE(tessellate(CubeDesc{}).normals.empty());
    EXPECT_EQ(tessellate(CubeDesc{}).face_vertex_counts.size(), 6U);
}

TEST(Tessellate, BodiesOfRevolutionAreClosedAndOutward) {
    for (Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
        expect_body(CylinderDesc{0.7, 3, axis}, along(axis, 1.5, 0.7), kPolygon * kPi * 0.49 * 3, 1e-5);
        expect_body(ConeDesc{0.7, 3, axis}, along(axis, 1.5, 0.7), kPolygon * kPi * 0.49, 1e-5);
        const double ball = 4 * kPi / 3 * 0.343;
        expect_body(CapsuleDesc{0.7, 3, axis}, along(axis, 2.2, 0.7), ball + kPi * 0.49 * 3, 5e-3);
        expect_body(CapsuleDesc{0.7, 0, axis}, along(axis, 0.7, 0.7), ball, 5e-3);
    }
    expect_body(SphereDesc{0.7}, {0.7, 0.7, 0.7}, 4 * kPi / 3 * 0.343, 5e-3);
}

// UsdGeomCone: the apex lies towards the positive end of the axis.
TEST(Tessellate, ConesPointAlongTheirAxis) {
    for (Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
        const TriangleMesh mesh = make_triangle_mesh(tessellate(ConeDesc{1, 2, axis}), {}, "/cone");
        const Vec3 up = along(axis, 1, 0);
        for (std::size_t i = 0; i < mesh.point_count(); ++i) {
            const Vec3 p{mesh.points[i]};
            if (dot(p, up) > 0.99) EXPECT_LT(length(p - up), 1e-6);
        }
    }
}

TEST(Tessellate, PlanesFaceTheirAxisAndKnowWidthFromLength) {
    const std::array<Vec3, 3> half{Vec3{0, 1, 2}, Vec3{2, 0, 1}, Vec3{2, 1, 0}};
    for (Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
        const TriangleMesh mesh = make_triangle_mesh(tessellate(PlaneDesc{4, 2, axis}), {}, "/plane");
        expect_extent(mesh, half[static_cast<std::size_t>(axis)]);
        double area = 0;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += dot(area_vector(mesh, t), along(axis, 1, 0));
        EXPECT_NEAR(area, 8, 1e-6);
    }
}

TEST(Tessellate, TextureCoordinatesFillTheSquare) {
    for (const MeshDesc& mesh : {tessellate(CubeDesc{}), tessellate(CylinderDesc{}), tessellate(ConeDesc{}),
                                 tessellate(CapsuleDesc{}), tessellate(PlaneDesc{}), tessellate(SphereDesc{})}) {
        ASSERT_EQ(mesh.st.size(), mesh.points.size());
        for (const Float2& st : mesh.st) {
            EXPECT_GE(std::min(st[0], st[1]), 0);
            EXPECT_LE(std::max(st[0], st[1]), 1);
        }
    }
}

}  // namespace
}  // namespace etendue::test
