// Triangles that hardly are any: needles, of no area, and several in one place.

#include <cmath>
#include <string>

#include "extremes/agreement.h"
#include "extremes/extreme.h"
#include "extremes/pictures.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

Float3 corner(double x, double y, double z) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

/// The unit square [-1, 1]^2 at z = 0, cut into that many strips; its normal is +z.
MeshDesc strips(int count) {
    MeshDesc mesh;
    for (int i = 0; i <= count; ++i) {
        const double x = -1 + 2.0 * i / count;
        mesh.points.push_back(corner(x, -1, 0));
        mesh.points.push_back(corner(x, 1, 0));
    }
    for (int i = 0; i < count; ++i) {
        mesh.face_vertex_counts.insert(mesh.face_vertex_counts.end(), {3, 3});
        mesh.face_vertex_indices.insert(mesh.face_vertex_indices.end(),
                                        {2 * i, 2 * i + 2, 2 * i + 3, 2 * i, 2 * i + 3, 2 * i + 1});
    }
    return mesh;
}

/// The same square in pairs of strips: in each two flat triangles, tip to tip, whose edges are all long, and needles
/// about them.
MeshDesc flat_triangles(int pairs) {
    MeshDesc mesh;
    for (int i = 0; i <= 2 * pairs; ++i) {
        for (const double y : {-1, 0, 1}) mesh.points.push_back(corner(-1 + 1.0 * i / pairs, y, 0));
    }
    const auto add = [&mesh](int a, int b, int c) {
        mesh.face_vertex_counts.push_back(3);
        mesh.face_vertex_indices.insert(mesh.face_vertex_indices.end(), {a, b, c});
    };
    for (int pair = 0; pair < pairs; ++pair) {
        const int left = 6 * pair;  // points from the bottom up; only the middle column's is used in between
        const int middle = left + 3;
        const int right = left + 6;
        add(left, middle + 1, left + 2);
        add(left, middle, middle + 1);
        add(middle + 1, middle + 2, left + 2);
        add(right, right + 2, middle + 1);
        add(right, middle + 1, middle);
        add(middle + 1, right + 2, middle + 2);
    }
    return mesh;
}

/// All kinds of faces of no area: a point, a line, a line there and back; far away and on the square.
void add_degenerate_faces(MeshDesc& mesh) {
    const auto first = static_cast<std::int32_t>(mesh.points.size());
    for (const Float3& p : {corner(0, 0, 0), corner(0.5, 0.25, 0), corner(-0.5, -0.25, 0), corner(1e6, 0, 0),
                            corner(1e-30, 0, 0), corner(0, 1e-30, 0)}) {
        mesh.points.push_back(p);
    }
    for (const std::array<int, 3>& face :
         {std::array{0, 0, 0}, std::array{0, 1, 1}, std::array{1, 0, 2}, std::array{0, 3, 0}, std::array{0, 4, 5}}) {
        mesh.face_vertex_counts.push_back(3);
        for (const int i : face) mesh.face_vertex_indices.push_back(first + i);
    }
}

/// A square, lit from a corner of the room, with a wall beside it.
SceneDescription room_with(const MeshDesc& square, const Color& emission = {0, 0, 0}) {
    SceneBuilder b;
    const int grey = b.material(DiffuseMaterial{}, emission);
    b.shape(square, grey);
    b.quad({1, -1, 0}, {0, 0, 2}, {0, 2, 0}, b.diffuse(0.8));
    b.rect_light({-0.9, 0.3, 1.2}, {0.4, 0, -1}, 0.5, 0.5, 4);
    b.camera({-0.4, 0.1, 5}, {0, 0, 0}, 26);
    return b.scene();
}

void expect_same(const SceneDescription& odd, const SceneDescription& plain, const std::string& what) {
    for (const auto& [integrator, name] : kNamedIntegrators) {
        const int samples = integrator == IntegratorKind::Light ? 64 : 16;
        const Replicas a = replicas(odd, integrator, samples);
        const Replicas b = replicas(plain, integrator, samples);
        EXPECT_TRUE(same_picture(a, b, 0.05)) << what << name;
        EXPECT_TRUE(at_most({"triangles", what + ", " + name, "the plain square: standard errors apart"},
                            errors_apart(a, b), kMostErrors));
    }
}

TEST(Triangles, NeedlesMakeASquare) {
    const int count = 4000;  // 2000 times as long as wide
    expect_same(room_with(strips(count)), room_with(strips(1)), "a square of 8000 needles");
    expect_same(room_with(strips(count), {2, 2, 2}), room_with(strips(1), {2, 2, 2}),
                "a glowing square of 8000 needles");
}

/// About no axis that a float knows: what is 0 along an axis is exact, and shows no roundings.
MeshDesc turned(MeshDesc mesh) {
    const Vec3 x = normalize(Vec3{0.9, 0.3, -0.2});
    const Vec3 y = normalize(cross(Vec3{0.1, -0.2, 0.95}, x));
    const Vec3 z = cross(x, y);
    for (Float3& point : mesh.points) {
        const Vec3 p = x * point[0] + y * point[1] + z * point[2];
        point = corner(p.x, p.y, p.z);
    }
    return mesh;
}

/// Nothing is before a flat thing, so it is as bright as its sky if it is white, and as bright as it glows.
TEST(Triangles, FlatOnesDoNotMeetThemselves) {
    for (const int pairs : {500, 5000}) {
        for (const bool glows : {false, true}) {
            SceneBuilder b;
            const double glow = glows ? 1 : 0;
            b.shape(turned(flat_triangles(pairs)), b.material(DiffuseMaterial{{{1, 1, 1}}}, {glow, glow, glow}));
            LightDesc sky;
            sky.name = "/sky";
            sky.kind = LightKind::Dome;
            if (!glows) b.light(sky);
            b.camera({0, 0, 4}, {0, 0, 0}, 8);
            RenderSettings settings = small_settings(IntegratorKind::Path, 8, 16);
            settings.max_depth = glows ? 4 : 1;
            const Replicas seen = render_replicas(b.scene(), settings, kReplicas, 1);
            EXPECT_TRUE(mean_is(seen, 1, 0.01)) << pairs << glows;
            EXPECT_TRUE(at_most({"triangles",
                                 "a turned square of " + std::to_string(6 * pairs) + " flat triangles, " +
                                     (glows ? "glowing" : "white, under an even sky"),
                                 "radiance 1: relative deviation of the mean"},
                                relative_error(seen, 1), 0.02));
        }
    }
}

TEST(Triangles, FlatOnesMakeASquare) {
    const MeshDesc flat = turned(flat_triangles(500));
    const MeshDesc square = turned(strips(1));
    expect_same(room_with(flat), room_with(square), "a turned square of 3000 flat triangles");
    expect_same(room_with(flat, {2, 2, 2}), room_with(square, {2, 2, 2}), "a turned glowing square of 3000");
}

TEST(Triangles, WithoutAreaAreNotThere) {
    MeshDesc mesh = strips(1);
    add_degenerate_faces(mesh);
    expect_same(room_with(mesh), room_with(strips(1)), "faces of no area");
    expect_same(room_with(mesh, {2, 2, 2}), room_with(strips(1), {2, 2, 2}), "glowing faces of no area");
}

TEST(Triangles, InOnePlaceAreOne) {
    MeshDesc mesh = strips(1);
    const std::vector<std::int32_t> once = mesh.face_vertex_indices;
    for (int i = 0; i < 3; ++i) {
        mesh.face_vertex_counts.insert(mesh.face_vertex_counts.end(), {3, 3});
        mesh.face_vertex_indices.insert(mesh.face_vertex_indices.end(), once.begin(), once.end());
    }
    expect_same(room_with(mesh), room_with(strips(1)), "a square four times in one place");
    SceneDescription two = room_with(strips(1));
    two.shapes.push_back(two.shapes[0]);
    two.shapes.back().name = "/again";
    expect_same(two, room_with(strips(1)), "two shapes in one place");
}

/// A mesh of nothing but faces without area has nothing to shine with.
TEST(Triangles, AloneWithoutAreaAreDark) {
    MeshDesc nothing;
    add_degenerate_faces(nothing);
    SceneBuilder b;
    b.shape(nothing, b.material(DiffuseMaterial{}, {1, 1, 1}));
    b.camera({0, 0, 5}, {0, 0, 0}, 26);
    double brightest = 0;
    for (const IntegratorKind integrator : kIntegrators) {
        const Picture seen = picture(b.scene(), quick_settings(integrator));
        brightest = std::max(brightest, seen.mean());
        EXPECT_EQ(seen.invalid, 0);
    }
    EXPECT_TRUE(at_most({"triangles", "a glowing mesh of no area", "black: the brightest mean"}, brightest, 0));
}

}  // namespace
}  // namespace etendue::test
