#include "scene/scene.h"

#include <array>
#include <set>

#include <gtest/gtest.h>

#include "core/math/random_math.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

std::optional<SurfaceInteraction> look_down(const Scene& scene, double x, double y) {
    return scene.intersect({{x, y, 10}, {0, 0, -1}});
}

/// Squares [i, i + 1] x [0, 1], one per slot, facing +z.
MeshDesc squares_in_a_row(const std::vector<std::int32_t>& slots) {
    MeshDesc mesh;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const auto x = static_cast<float>(i);
        const auto first = static_cast<std::int32_t>(mesh.points.size());
        mesh.points.insert(mesh.points.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0}});
        mesh.face_vertex_counts.push_back(4);
        for (std::int32_t k = 0; k < 4; ++k) mesh.face_vertex_indices.push_back(first + k);
    }
    mesh.face_materials = slots;
    return mesh;
}

Rgb radiance(const Scene& scene, const SurfaceInteraction& si, const Vec3& w) {
    return scene.light(si.light).radiance({si.p, si.n_g, si.st, si.p_error}, w);
}

TEST(Scene, GivesEachFaceItsMaterial) {
    SceneBuilder b;
    const int first = b.diffuse(0.1);
    const int second = b.diffuse(0.2);
    const int third = b.diffuse(0.3);
    const int shape = b.shape(squares_in_a_row({2, 0, 1, 0}), first);
    b.scene().shapes[static_cast<std::size_t>(shape)].materials = {second, third, first};
    const Scene scene(b.scene(), {});
    EXPECT_EQ(look_down(scene, 0.3, 0.4)->material, first);
    EXPECT_EQ(look_down(scene, 1.3, 0.4)->material, second);
    EXPECT_EQ(look_down(scene, 2.3, 0.4)->material, third);
    EXPECT_EQ(look_down(scene, 3.3, 0.4)->material, second);
    EXPECT_DOUBLE_EQ(scene.albedo(*look_down(scene, 2.3, 0.4)).g, 0.3);
    EXPECT_FALSE(scene.light_count() > 0);
    EXPECT_EQ(look_down(scene, 0.3, 0.4)->light, -1);
}

TEST(Scene, EmissiveFacesAreLights) {
    SceneBuilder b;
    const int grey = b.diffuse(0.5);
    const int red = b.material(DiffuseMaterial{}, {3, 0, 0});
    const int green = b.material(DiffuseMaterial{}, {0, 2, 0});
    const int shape = b.shape(squares_in_a_row({0, 1, 2, 1}), grey);
    b.scene().shapes[static_cast<std::size_t>(shape)].materials = {grey, red, green};
    const Scene scene(b.scene(), {});
    EXPECT_EQ(look_down(scene, 0.5, 0.4)->light, -1);
    const SurfaceInteraction one = *look_down(scene, 1.5, 0.4);
    const SurfaceInteraction two = *look_down(scene, 2.5, 0.4);
    EXPECT_EQ(radiance(scene, one, {0, 0, 1}), Rgb(3, 0, 0));
    EXPECT_EQ(radiance(scene, two, {0, 0, 1}), Rgb(0, 2, 0));
    EXPECT_EQ(radiance(scene, one, {0, 0, -1}), Rgb(0));  // the front side only
    EXPECT_EQ(look_down(scene, 3.5, 0.4)->light, one.light);
    EXPECT_NE(one.light, two.light);
    // Lambert: power = pi * area * radiance. Red glows on two squares.
    EXPECT_NEAR(scene.light(one.light).power().r, 2 * kPi * 3, 1e-9);
    EXPECT_NEAR(scene.light(two.light).power().g, kPi * 2, 1e-9);
    EXPECT_TRUE(Scene::scatters(one));
}

TEST(Scene, LeftHandedAndMirroredFacesGlowForwards) {
    for (bool left_handed : {false, true}) {
        for (bool mirrored : {false, true}) {
            for (bool instanced : {false, true}) {
                MeshDesc mesh = squares_in_a_row({0});
                mesh.left_handed = left_handed;
                SceneBuilder b;
                const int glow = b.material(DiffuseMaterial{}, {1, 1, 1});
                const Matrix4 placed = scaling(1, mirrored ? -1 : 1, 1);
                if (instanced) {
                    b.scene().geometries.emplace_back(mesh);
                    b.scene().groups = {{"/group", {{"/shape", 0, {glow}, {}}}}};
                    b.scene().instances = {{"/instance", 0, placed}};
                } else {
                    b.shape(mesh, glow, placed);
                }
                const Scene scene(b.scene(), {});
                const SurfaceInteraction si = *look_down(scene, 0.5, mirrored ? -0.5 : 0.5);
                const double front = left_handed ? -1 : 1;
                EXPECT_NEAR(si.n_g.z, front, 1e-12);
                EXPECT_EQ(radiance(scene, si, {0, 0, front}), Rgb(1));
                EXPECT_EQ(radiance(scene, si, {0, 0, -front}), Rgb(0));
                // The light that a receiver samples faces the same way.
                EXPECT_TRUE(scene.light(si.light).sample_direct({0.2, 0.1, 2 * front}, {0.5, 0.5}));
                const auto behind = scene.light(si.light).sample_direct({0.2, 0.1, -2 * front}, {0.5, 0.5});
                EXPECT_TRUE(!behind || is_black(behind->weight));
            }
        }
    }
}

TEST(Scene, EveryInstanceIsALightOfItsOwn) {
    SceneBuilder b;
    const int grey = b.diffuse(0.5);
    const int glow = b.material(DiffuseMaterial{}, {1, 2, 3});
    b.scene().geometries = {squares_in_a_row({0, 1}), squares_in_a_row({0})};
    b.scene().groups = {
        {"/group", {{"/group/dark", 1, {grey}, translation({0, 2, 0})}, {"/group/half", 0, {grey, glow}, {}}}}};
    b.scene().instances = {{"/a", 0, translation({0, 0, 0})},
                           {"/b", 0, scaling(2, 3, 1, {10, 0, 0})},
                           {"/c", 0, scaling(-1, 1, 1, {-10, 0, 0})}};
    const Scene scene(b.scene(), {});
    EXPECT_EQ(look_down(scene, 0.5, 0.5)->light, -1);
    EXPECT_EQ(look_down(scene, 0.5, 2.5)->light, -1);
    const int a = look_down(scene, 1.5, 0.5)->light;
    const int wide = look_down(scene, 13, 1.5)->light;
    const int mirrored = look_down(scene, -11.5, 0.5)->light;
    EXPECT_EQ((std::set<int>{a, wide, mirrored}).size(), 3U);
    EXPECT_GE(std::min({a, wide, mirrored}), 0);
    EXPECT_NEAR(scene.light(a).power().g, 2 * kPi, 1e-6);
    EXPECT_NEAR(scene.light(wide).power().g, 12 * kPi, 1e-5);
    EXPECT_NEAR(scene.light(mirrored).power().g, 2 * kPi, 1e-6);
    EXPECT_EQ(look_down(scene, 13, 1.5)->material, glow);
}

TEST(Scene, InstancesCarryGeometryWhole) {
    SceneBuilder b;
    const int grey = b.diffuse(0.5);
    MeshDesc tilted;
    tilted.points = {{0, 0, 0}, {1, 0, 1}, {1, 1, 1}, {0, 1, 0}};
    tilted.st = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    tilted.face_vertex_counts = {4};
    tilted.face_vertex_indices = {0, 1, 2, 3};
    b.scene().geometries = {tilted};
    b.scene().groups = {{"/group", {{"/group/shape", 0, {grey}, {}}}}};
    b.scene().instances = {{"/instance", 0, scaling(2, 3, 4, {5, 6, 7})}};
    Requirements needs = find_requirements(b.scene(), {});
    needs.texture_coordinates = {CoordinateUse::Tangents};
    const Scene scene(b.scene(), {}, {needs});
    const auto si = scene.intersect({{6, 7.5, 100}, {0, 0, -1}});
    ASSERT_TRUE(si);
    EXPECT_NEAR(si->p.x, 6, 1e-5);
    EXPECT_NEAR(si->p.y, 7.5, 1e-5);
    EXPECT_NEAR(si->p.z, 9, 1e-5);
    EXPECT_NEAR(si->st.x, 0.5, 1e-6);
    EXPECT_NEAR(si->st.y, 0.5, 1e-6);
    EXPECT_LE(length(si->dpds - Vec3(2, 0, 4)), 1e-6);
    EXPECT_LE(length(si->dpdt - Vec3(0, 3, 0)), 1e-6);
    EXPECT_LE(length(si->n_g - normalize(Vec3{-4, 0, 2})), 1e-6);
}

TEST(Scene, MeshLightsTakeTheirShapeOver) {
    for (bool tinted : {false, true}) {
        SceneBuilder b;
        const int glow = b.material(DiffuseMaterial{{{0.5, 0.5, 0.5}}}, {0.5, 0.25, 0});
        const int shape = b.shape(squares_in_a_row({0}), glow);
        LightDesc light;
        light.kind = LightKind::Mesh;
        light.shape = shape;
        light.intensity = 4;
        light.tinted_by_material = tinted;
        b.light(light);
        const Scene scene(b.scene(), {});
        const SurfaceInteraction si = *look_down(scene, 0.5, 0.4);
        ASSERT_EQ(si.light, 0);
        EXPECT_EQ(radiance(scene, si, {0, 0, 1}), tinted ? Rgb(2, 1, 0) : Rgb(4));
        EXPECT_EQ(Scene::scatters(si), tinted);  // else the light hides the material
    }
}

/// Each slot of a tinted mesh light glows as its own material does; all of the mesh counts for normalising.
TEST(Scene, MeshLightsAreTintedSlotBySlot) {
    SceneBuilder b;
    const int red = b.material(DiffuseMaterial{}, {2, 0, 0});
    const int black = b.diffuse(0.5);
    const int green = b.material(DiffuseMaterial{}, {0, 3, 0});
    const int shape = b.shape(squares_in_a_row({0, 1, 2, 0}), red);
    b.scene().shapes[static_cast<std::size_t>(shape)].materials = {red, black, green};
    LightDesc light;
    light.kind = LightKind::Mesh;
    light.shape = shape;
    light.tinted_by_material = true;
    light.normalize = true;
    light.intensity = 20;
    b.light(light);
    b.light(point_light({0, 0, 5}, 1));  // keeps its index
    const Scene scene(b.scene(), {});
    EXPECT_TRUE(scene.light(1).delta());
    const std::array<Rgb, 4> expected{Rgb(10, 0, 0), Rgb(), Rgb(0, 15, 0), Rgb(10, 0, 0)};  // 20 over the area of 4
    for (std::size_t i = 0; i < 4; ++i) {
        const auto si = look_down(scene, static_cast<double>(i) + 0.5, 0.5);
        ASSERT_TRUE(si && si->light >= 0);
        const LightPoint y{si->p, si->n_g, si->st, si->p_error};
        EXPECT_EQ(scene.light(si->light).radiance(y, {0, 0, 1}), expected[i]) << i;
    }
    const auto of = [&](double x) -> const Light& { return scene.light(look_down(scene, x, 0.5)->light); };
    EXPECT_NEAR(of(0.5).power().r, 20 * kPi, 1e-12);  // both its squares
    EXPECT_NEAR(of(2.5).power().g, 15 * kPi, 1e-12);
}

TEST(Scene, LightShapesAbsorb) {
    SceneBuilder b;
    b.rect_light({0.5, 0.5, 0}, {0, 0, 1}, 1, 1, 2);
    const Scene scene(b.scene(), {});
    const SurfaceInteraction si = *look_down(scene, 0.4, 0.4);
    EXPECT_EQ(si.light, 0);
    EXPECT_FALSE(Scene::scatters(si));
    EXPECT_EQ(scene.albedo(si), Rgb(0));
}

// Light subpaths from infinity must reach whatever can be seen, lens included: the disk they start from is as wide as
// the scene's bounding sphere.
TEST(Scene, InfiniteLightsCoverTheSceneAndTheLens) {
    SceneBuilder b;
    b.quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, b.diffuse(0.5));
    LightDesc sun;
    sun.kind = LightKind::Distant;
    sun.angle = 0;
    b.light(sun);  // shines along -z
    const auto widest = [&](const std::vector<Vec3>& lens_points) {
        const Scene scene(b.scene(), lens_points);
        Rng rng(1, 0, 0);
        double reach = 0;
        for (int i = 0; i < 1000; ++i) {
            const EmissionSample s = scene.light(0).sample_emission(rng.next_2d(), rng.next_2d());
            reach = std::max(reach, std::hypot(s.origin.x, s.origin.y));
        }
        return reach;
    };
    EXPECT_GE(widest({}), 1.4);
    EXPECT_LT(widest({}), 1.5);
    // A lens at (9, 0, 0): the box is 10 long and 2 wide.
    EXPECT_GT(widest({{9, 0, 0}}), 8);
}

TEST(Scene, MayBeEmpty) {
    const Scene scene(SceneDescription{}, {});
    EXPECT_FALSE(look_down(scene, 0, 0));
    EXPECT_FALSE(scene.light_count() > 0);
    EXPECT_TRUE(scene.visible(RayEnd::free({0, 0, 0}), RayEnd::free({1, 2, 3})));
    EXPECT_TRUE(scene.sees_infinity(RayEnd::free({0, 0, 0}), {0, 0, 1}));
}

}  // namespace
}  // namespace etendue::test
