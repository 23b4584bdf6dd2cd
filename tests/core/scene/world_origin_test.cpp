// From where positions are measured: the world's origin for scenes about it, next to the scene for others.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/math/random_math.h"
#include "scene/world_origin.h"
#include "support/invalid_operations.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

/// A box of half-width 1, a camera 3 away from its middle.
SceneBuilder box() {
    SceneBuilder b;
    b.open_box(b.diffuse(0.5));
    b.camera({0, 0, 3}, {0, 0, 0}, 40);
    return b;
}

SceneDescription far_box(const Vec3& offset) {
    SceneDescription scene = box().scene();
    for (ShapeDesc& shape : scene.shapes) shape.parent_from_object = translation(offset);
    scene.cameras[0].world_from_camera = translation(offset + Vec3{0, 0, 3});
    return scene;
}

Vec3 origin_of(const SceneDescription& scene) { return find_origins(scene, scene.cameras[0]).world; }

TEST(WorldOrigin, StaysWhereTheSceneIsAboutIt) {
    EXPECT_EQ(origin_of(box().scene()), Vec3{});
    // Its own size away still.
    EXPECT_EQ(origin_of(far_box({1.9, -1.9, 1.9})), Vec3{});
}

/// A scene without a size has no grid.
TEST(WorldOrigin, OfACameraAloneIsTheWorlds) {
    SceneBuilder b;
    b.camera({3, 2, 1}, {0, 0, 0}, 40);
    Vec3 origin{1, 1, 1};
    EXPECT_FALSE(raises_invalid([&] { origin = origin_of(b.scene()); }));
    EXPECT_EQ(origin, Vec3{});
}

TEST(WorldOrigin, FollowsTheSceneInWholeSteps) {
    const Vec3 near = origin_of(far_box({1e6, -3e5, 0}));
    EXPECT_LT(length(near - Vec3{1e6, -3e5, 0}), 8);
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(std::fmod(near[axis], 4), 0);
    const Vec3 moved_by_steps = origin_of(far_box({1e6 + 0x1p20, -3e5, -0x1p30}));
    EXPECT_EQ(moved_by_steps, (near + Vec3{0x1p20, 0, -0x1p30}));
}

// Else every shape would be placed anew while somebody looks around.
TEST(WorldOrigin, StaysWhenCamerasAndLampsMove) {
    SceneBuilder b;
    b.shape(CubeDesc{10}, b.diffuse(0.5), translation({25, 25, 25}));
    b.camera({25, 25, 35}, {25, 25, 25}, 40);
    b.light(point_light({25, 25, 35}, 1));
    SceneDescription& scene = b.scene();
    const Vec3 origin = origin_of(scene);
    for (int step = 0; step < 60; ++step) {
        const double z = 35 * std::pow(1.1, step);
        scene.cameras[0].world_from_camera = translation({25, 25, z});
        EXPECT_EQ(origin_of(scene), origin) << z;
        scene.lights[0].world_from_light = translation({z, 25, 25});
        EXPECT_EQ(origin_of(scene), origin) << z;
    }
}

TEST(WorldOrigin, CountsInstancesAndLampsButNoSkies) {
    SceneDescription scene;
    scene.cameras = far_box({1e6, 0, 0}).cameras;
    LightDesc light;
    light.kind = LightKind::Dome;
    scene.lights = {light};
    EXPECT_EQ(origin_of(scene), Vec3{});  // a camera alone has no size
    light.kind = LightKind::Sphere;
    light.world_from_light = translation({1e6, 0, 0});
    scene.lights.push_back(light);
    EXPECT_LT(length(origin_of(scene) - Vec3{1e6, 0, 0}), 8);
    scene.lights.pop_back();
    scene.geometries = {CubeDesc{2}};
    scene.groups = {{"/group", {{"/group/cube", 0, {0}, {}}}}};
    scene.instances = {{"/instance", 0, translation({1e6, 0, 0})}};
    EXPECT_LT(length(origin_of(scene) - Vec3{1e6, 0, 0}), 8);
}

TEST(WorldOrigin, GroupsHaveTheirOwn) {
    SceneDescription scene;
    scene.cameras = box().scene().cameras;
    scene.geometries = {CubeDesc{2}};
    scene.groups = {{"/near", {{"/near/cube", 0, {0}, translation({0.5, 0, 0})}}},
                    {"/far", {{"/far/cube", 0, {0}, translation({1e6, -3e5, 0})}}}};
    scene.instances = {{"/instance", 1, translation({-1e6, 3e5, 0})}};
    const Origins origins = find_origins(scene, scene.cameras[0]);
    EXPECT_EQ(origins.world, Vec3{});
    EXPECT_EQ(origins.of_group(0), Vec3{});
    EXPECT_LT(length(origins.of_group(1) - Vec3{1e6, -3e5, 0}), 4);
    EXPECT_EQ(origins.of_group(2), Vec3{});
}

TEST(WorldOrigin, PlacementsAreOfWhatIsMeasuredElsewhere) {
    Matrix4 turned;  // (x, y, z) to (-2 y, 2 x, 2 z), all over 2
    turned.m = {0, -2, 0, 7, 2, 0, 0, 8, 0, 0, 2, 9, 0, 0, 0, 2};
    const Matrix4 placed = measured_from({10, 20, 30}, turned);
    EXPECT_EQ(placed.m[3], 7 - 40);
    EXPECT_EQ(placed.m[7], 8 + 20);
    EXPECT_EQ(placed.m[11], 9 + 60);
}

/// Complaints are others' business.
TEST(WorldOrigin, TakesWhatIsWrong) {
    SceneDescription scene = far_box({1e6, 0, 0});
    scene.shapes[0].geometry = 99;
    scene.shapes[1].geometry = -1;
    EXPECT_LT(length(origin_of(scene) - Vec3{1e6, 0, 0}), 8);
    scene.cameras[0].world_from_camera.m[3] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(is_finite(origin_of(scene)));
    scene.cameras[0].world_from_camera.m[15] = 0;
    EXPECT_TRUE(is_finite(origin_of(scene)));
}

TEST(WorldOrigin, RelativePlacementsHeedTheLastElement) {
    Matrix4 doubled = translation({12, 14, 16});
    doubled.m[15] = 2;
    const Matrix4 relative = relative_to({1, 2, 3}, doubled);
    EXPECT_EQ(relative.m[3], 10);
    EXPECT_EQ(relative.m[7], 10);
    EXPECT_EQ(relative.m[11], 10);
}

}  // namespace
}  // namespace etendue::test
