#include "geometry/triangle_mesh.h"

#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include <etendue/error.h>

#include "core/math/random_math.h"

namespace etendue::test {
namespace {

/// Two squares side by side in the xy plane, facing +z: six points, two faces, eight corners.
MeshDesc two_squares() {
    MeshDesc mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    mesh.face_vertex_counts = {4, 4};
    mesh.face_vertex_indices = {0, 1, 4, 3, 1, 2, 5, 4};
    return mesh;
}

/// The message of the SceneError that the mesh causes; empty when it causes none.
std::string error_of(const MeshDesc& mesh, const Transform& placement = {}) {
    try {
        (void)make_triangle_mesh(mesh, placement, "/World/bad");
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

struct BadMesh {
    const char* what;
    std::function<void(MeshDesc&)> spoil;
    const char* complaint;
};

TEST(TriangleMesh, NamesThePrimOfEveryBadInput) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    const std::vector<BadMesh> cases{
        {"no points", [](MeshDesc& m) { m.points.clear(); }, "empty"},
        {"no faces", [](MeshDesc& m) { m.face_vertex_counts.clear(); }, "empty"},
        {"two corners", [](MeshDesc& m) { m.face_vertex_counts[0] = 2; }, "2 vertices"},
        {"no corner", [](MeshDesc& m) { m.face_vertex_counts[1] = 0; }, "0 vertices"},
        {"negative count", [](MeshDesc& m) { m.face_vertex_counts[1] = -4; }, "-4 vertices"},
        {"too many corners", [](MeshDesc& m) { m.face_vertex_counts[1] = 5; }, "add up to 9"},
        {"too few corners", [](MeshDesc& m) { m.face_vertex_indices.pop_back(); }, "there are 7"},
        {"index past the end", [](MeshDesc& m) { m.face_vertex_indices[3] = 6; }, "holds 6"},
        {"negative index", [](MeshDesc& m) { m.face_vertex_indices[3] = -1; }, "holds -1"},
        {"NaN point", [=](MeshDesc& m) { m.points[2][1] = nan; }, "points[2]"},
        {"infinite point", [=](MeshDesc& m) { m.points[5][0] = -inf; }, "points[5]"},
        {"NaN normal", [=](MeshDesc& m) { m.normals.assign(6, {0, nan, 1}); }, "normals[0]"},
        {"infinite st", [=](MeshDesc& m) { m.st.assign(6, {inf, 0}); }, "texture coordinates[0]"},
        {"vertex normals short", [](MeshDesc& m) { m.normals.assign(5, {0, 0, 1}); }, "normals has 5"},
        {"uniform normals",
         [](MeshDesc& m) {
             m.normals.assign(6, {0, 0, 1});
             m.normals_interpolation = Interpolation::Uniform;
         },
         "where 2"},
        {"face-varying st",
         [](MeshDesc& m) {
             m.st.assign(6, {0, 0});
             m.st_interpolation = Interpolation::FaceVarying;
         },
         "where 8"},
        {"constant st",
         [](MeshDesc& m) {
             m.st.assign(2, {0, 0});
             m.st_interpolation = Interpolation::Constant;
         },
         "where 1"},
        {"face materials", [](MeshDesc& m) { m.face_materials = {0}; }, "face materials"},
    };
    ASSERT_EQ(error_of(two_squares()), "");
    for (const BadMesh& bad : cases) {
        MeshDesc mesh = two_squares();
        bad.spoil(mesh);
        const std::string message = error_of(mesh);
        EXPECT_NE(message.find("/World/bad"), std::string::npos) << bad.what << ": " << message;
        EXPECT_NE(message.find(bad.complaint), std::string::npos) << bad.what << ": " << message;
    }
}

TEST(TriangleMesh, RefusesPointsThatLeaveFloat) {
    MeshDesc mesh = two_squares();
    mesh.points[1] = {1e30F, 0, 0};
    EXPECT_NE(error_of(mesh, Transform(scaling(1e10, 1e10, 1e10))).find("/World/bad"), std::string::npos);
}

TEST(TriangleMesh, InterpolatesNormalsAndTextureCoordinates) {
    struct Case {
        Interpolation interpolation;
        std::size_t count;
        std::array<std::array<int, 3>, 4> expected;  ///< value per triangle and corner
    };
    const std::vector<Case> cases{
        {Interpolation::Constant, 1, {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}},
        {Interpolation::Uniform, 2, {{{0, 0, 0}, {0, 0, 0}, {1, 1, 1}, {1, 1, 1}}}},
        {Interpolation::Vertex, 6, {{{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}}},
        {Interpolation::FaceVarying, 8, {{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}}},
    };
    for (const Case& c : cases) {
        MeshDesc desc = two_squares();
        desc.normals_interpolation = desc.st_interpolation = c.interpolation;
        for (std::size_t i = 0; i < c.count; ++i) {
            const auto number = static_cast<float>(i);
            desc.normals.push_back({1, 10 * number, 0});
            desc.st.push_back({number, -number});
        }
        const TriangleMesh mesh = make_triangle_mesh(desc, {}, "/mesh");
        ASSERT_EQ(mesh.triangles.size(), 4U);
        for (std::size_t t = 0; t < 4; ++t) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const int i = c.expected[t][corner];
                EXPECT_EQ(mesh.corner_st(t, corner), (Float2{static_cast<float>(i), static_cast<float>(-i)}));
                const Vec3 n = mesh.corner_normal(t, corner);
                EXPECT_NEAR(n.y / n.x, 10 * i, 1e-4);
                EXPECT_NEAR(length(n), 1, 1e-6);
            }
        }
    }
}

TEST(TriangleMesh, KeepsMaterialsOfFaces) {
    MeshDesc desc = two_squares();
    desc.face_materials = {1, 0};
    const TriangleMesh mesh = make_triangle_mesh(desc, {}, "/mesh");
    EXPECT_EQ(mesh.material_slots, (std::vector<std::int32_t>{1, 1, 0, 0}));
}

Vec3 front(const TriangleMesh& mesh, std::size_t t) {
    return cross(mesh.point(t, 1) - mesh.point(t, 0), mesh.point(t, 2) - mesh.point(t, 0)) * mesh.outward;
}

TEST(TriangleMesh, FrontsFollowOrientationAndMirrors) {
    Rng rng(1, 0, 0);
    for (int i = 0; i < 20; ++i) {
        for (bool mirrored : {false, true}) {
            for (bool left_handed : {false, true}) {
                const Transform placement(random_affine(rng, 1, random_point(rng, 4), mirrored));
                MeshDesc desc = two_squares();
                desc.left_handed = left_handed;
                desc.normals.assign(6, {0, 0, 1});
                const TriangleMesh mesh = make_triangle_mesh(desc, placement, "/mesh");
                // UsdGeom: orientation says which side of the face is its front in object space; placing keeps it.
                const Vec3 expected = placement.normal({0, 0, left_handed ? -1.0 : 1.0});
                for (std::size_t t = 0; t < mesh.triangles.size(); ++t) EXPECT_GT(dot(front(mesh, t), expected), 0);
                // Authored normals mean what they say, whatever the orientation.
                EXPECT_GT(dot(mesh.corner_normal(0, 0), placement.normal({0, 0, 1})), 0);
                EXPECT_NEAR(dot(mesh.corner_normal(0, 0), placement.vector({1, 0, 0})), 0, 1e-6);
            }
        }
    }
}

TEST(TriangleMesh, LeavesRoomForEmbree) {
    const TriangleMesh mesh = make_triangle_mesh(two_squares(), {}, "/mesh");
    EXPECT_EQ(mesh.point_count(), 6U);
    EXPECT_EQ(mesh.points.size(), 7U);
}

TEST(TriangleMesh, SurvivesFacesWithoutArea) {
    MeshDesc desc = two_squares();
    desc.points.assign(6, {1, 1, 1});
    EXPECT_EQ(make_triangle_mesh(desc, {}, "/mesh").triangles.size(), 4U);
    desc = two_squares();
    desc.normals.assign(6, {0, 0, 0});
    EXPECT_EQ(length(make_triangle_mesh(desc, {}, "/mesh").corner_normal(0, 0)), 0);
}

}  // namespace
}  // namespace etendue::test
