// Where a camera stands that was put into a surface.

#include <cmath>

#include <gtest/gtest.h>

#include "scene/off_surfaces.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

TEST(OffSurfaces, AreOnTheOuterSide) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        SceneBuilder b;
        const double half = static_cast<float>(0.4 * scale);
        b.shape(CubeDesc{2 * half}, b.diffuse(0.5));
        const Scene scene(b.scene(), {});
        for (int axis = 0; axis < 3; ++axis) {
            for (const double side : {-1.0, 1.0}) {
                const auto along = [axis](double x) {
                    return Vec3{axis == 0 ? x : 0, axis == 1 ? x : 0, axis == 2 ? x : 0};
                };
                const Vec3 beside = Vec3{0.01, 0.02, 0.03} * scale;
                const Vec3 on = along(side * half) + beside - along(beside[axis]);
                const Vec3 off = off_surfaces(scene, on);
                EXPECT_GT(dot(off, along(side)), half) << scale << axis;
                EXPECT_LT(length(off - on), 1e-5 * half);
                // From there the surface is met.
                const auto si = scene.intersect({off, along(-side)});
                ASSERT_TRUE(si);
                EXPECT_GT(dot(si->n_g, along(side)), 0);
                // A millionth away is no coincidence.
                for (const double height : {-2e-6, 2e-6}) {
                    const Vec3 near = on + along(side * height * half);
                    EXPECT_EQ(off_surfaces(scene, near), near);
                }
            }
        }
        EXPECT_EQ(off_surfaces(scene, {}), Vec3{});
        const Vec3 outside{2 * half, half, 0};  // in the plane of a face, beside it
        EXPECT_EQ(off_surfaces(scene, outside), outside);
    }
}

// Rays know the plane of a flat triangle to less than the water's depth here.
TEST(OffSurfaces, LeavesTheCameraUnderAFlatTriangle) {
    MeshDesc water;  // 10 x 0.001, its edges all long, and along no axis
    water.points = {{-3, -4, 0}, {3, 4, 0.5F}, {-0.0008F, 0.0006F, 0.25F}};
    water.face_vertex_counts = {3};
    water.face_vertex_indices = {0, 1, 2};
    SceneBuilder b;
    b.shape(water, b.diffuse(0.5));
    const Scene scene(b.scene(), {});
    const Vec3 corner{water.points[0]};
    const Vec3 n = normalize(cross(Vec3{water.points[1]} - corner, Vec3{water.points[2]} - corner));
    const Vec3 middle = (corner + Vec3{water.points[1]} + Vec3{water.points[2]}) / 3;
    EXPECT_NE(off_surfaces(scene, middle), middle);
    for (const double depth : {2e-4, -2e-4}) {
        const Vec3 below = middle - n * depth;
        EXPECT_EQ(off_surfaces(scene, below), below);
    }
}

// Float knows of a surface what it knows of its corners, which may lie far from the camera and the origin.
TEST(OffSurfaces, OfALargeTiltedBox) {
    const double c = std::cos(0.3);
    const double s = std::sin(0.3);
    const Vec3 right{c, 0, -s};  // tilted about the second axis, then the first
    const Vec3 up{s * s, c, s * c};
    const Vec3 front{c * s, -s, c * c};
    constexpr double kHalf = 1000;
    const Vec3 top{0.1, 0.2, 0.3};  // the middle of its upper face
    Matrix4 tilted = translation(top - up * kHalf);
    for (std::size_t i = 0; i < 3; ++i) {
        const int axis = static_cast<int>(i);
        tilted.m[4 * i] = right[axis];
        tilted.m[4 * i + 1] = up[axis];
        tilted.m[4 * i + 2] = front[axis];
    }
    SceneBuilder b;
    b.shape(CubeDesc{2 * kHalf}, b.diffuse(0), tilted);
    const Scene scene(b.scene(), {});
    for (int i = 0; i < 64; ++i) {
        const Vec3 on = top + right * (0.02 * std::cos(i)) + front * (0.02 * std::sin(i));
        const Vec3 off = off_surfaces(scene, on);
        EXPECT_GT(dot(off - top, up), 0) << i;
        EXPECT_LT(length(off - on), 4e-6 * kHalf) << i;
        EXPECT_FALSE(scene.intersect({off, up})) << i;
        EXPECT_TRUE(scene.intersect({off, -up})) << i;
    }
}

TEST(OffSurfaces, NeedSurfaces) {
    const Scene scene(SceneDescription{}, {});
    EXPECT_EQ(off_surfaces(scene, {1, 2, 3}), (Vec3{1, 2, 3}));
}

}  // namespace
}  // namespace etendue::test
