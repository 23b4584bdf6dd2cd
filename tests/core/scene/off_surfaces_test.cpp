// Where a camera stands that was put into a surface.

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

TEST(OffSurfaces, NeedSurfaces) {
    const Scene scene(SceneDescription{}, {});
    EXPECT_EQ(off_surfaces(scene, {1, 2, 3}), (Vec3{1, 2, 3}));
}

}  // namespace
}  // namespace etendue::test
