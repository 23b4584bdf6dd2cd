// What is found to gather light, and the spheres around it.

#include "scene/casters.h"

#include <cmath>

#include <gtest/gtest.h>

#include "math/rng.h"
#include "math/sampling.h"
#include "scene/known_geometry.h"
#include "scene/scene.h"
#include "support/scene_builder.h"

namespace etendue {
namespace {

bool focuses(const MaterialModel& model) {
    MaterialDesc material;
    material.model = model;
    return focuses(material, TextureSet({}));
}

TEST(Casters, Materials) {
    ConductorMaterial metal;
    DielectricMaterial glass;
    OpenPbrMaterial open_pbr;
    PreviewSurfaceMaterial preview;
    EXPECT_TRUE(focuses(metal));
    EXPECT_TRUE(focuses(glass));
    EXPECT_FALSE(focuses(DiffuseMaterial{}));
    EXPECT_FALSE(focuses(open_pbr));  // plastic: a coat over a diffuse base
    EXPECT_FALSE(focuses(preview));
    metal.roughness.value = glass.roughness.value = 0.25;
    EXPECT_TRUE(focuses(metal));
    EXPECT_TRUE(focuses(glass));
    metal.roughness.value = glass.roughness.value = 0.8;
    EXPECT_FALSE(focuses(metal));
    EXPECT_FALSE(focuses(glass));
    open_pbr.transmission_weight.value = 1;
    open_pbr.specular_roughness.value = 0;
    EXPECT_TRUE(focuses(open_pbr));
    open_pbr.geometry_opacity.value = 0;  // nothing but a hole
    EXPECT_FALSE(focuses(open_pbr));
    preview.metallic.value = 1;
    preview.diffuse_color.value = {0.9, 0.8, 0.7};
    preview.roughness.value = 0.1;
    EXPECT_TRUE(focuses(preview));
    preview.diffuse_color.value = {0.01, 0.01, 0.01};  // black metal
    EXPECT_FALSE(focuses(preview));
}

bool has_delta_lobe(const MaterialModel& model) {
    MaterialDesc material;
    material.model = model;
    return has_delta_lobe(material, TextureSet({}));
}

TEST(Casters, DeltaLobes) {
    ConductorMaterial metal;
    DielectricMaterial glass;
    OpenPbrMaterial open_pbr;
    PreviewSurfaceMaterial preview;
    EXPECT_TRUE(has_delta_lobe(metal));
    EXPECT_TRUE(has_delta_lobe(glass));
    EXPECT_FALSE(has_delta_lobe(DiffuseMaterial{}));
    EXPECT_FALSE(has_delta_lobe(PhongMaterial{}));
    EXPECT_FALSE(has_delta_lobe(open_pbr));
    EXPECT_FALSE(has_delta_lobe(preview));
    metal.roughness.value = glass.roughness.value = 0.25;
    EXPECT_FALSE(has_delta_lobe(metal));
    EXPECT_FALSE(has_delta_lobe(glass));
    preview.opacity.value = 0.9;  // holes
    EXPECT_TRUE(has_delta_lobe(preview));
    open_pbr.specular_roughness.value = 0;  // a coat
    EXPECT_TRUE(has_delta_lobe(open_pbr));
}

std::vector<Sphere> casters_of(const ShapeDesc& shape, const SceneDescription& scene, const Transform& world) {
    std::vector<bool> focusing;
    for (const MaterialDesc& m : scene.materials) focusing.push_back(focuses(m.model));
    std::vector<PlacedShape> shapes;
    shapes.push_back(place_shape(shape, scene, false, find_requirements(scene, {}).texture_coordinates, {}));
    std::vector<Sphere> casters = find_casters(shapes, focusing);
    for (Sphere& caster : casters) caster = transformed(caster, world);
    return casters;
}

TEST(Casters, SphereAroundASphere) {
    test::SceneBuilder b;
    b.shape(SphereDesc{0.5}, b.material(DielectricMaterial{}), test::look_at({1, 2, 3}, {2, 0, 1}));
    b.shape(SphereDesc{0.5}, b.diffuse(0.5));
    const SceneDescription& scene = b.scene();
    Matrix4 twice = test::translation({1, 0, 0});
    twice.m[0] = twice.m[5] = twice.m[10] = 2;
    const auto casters = casters_of(scene.shapes[0], scene, Transform(twice));
    ASSERT_EQ(casters.size(), 1);
    EXPECT_NEAR(length(casters[0].center - Vec3{3, 4, 6}), 0, 1e-12);
    EXPECT_NEAR(casters[0].radius, 1, 1e-12);
    EXPECT_TRUE(casters_of(scene.shapes[1], scene, {}).empty());
}

TEST(Casters, EllipsoidsAreInside) {
    test::SceneBuilder b;
    Matrix4 sheared;
    sheared.m = {1.2, 0.4, -0.3, 0.3, 0.1, 0.7, 0.5, -0.2, -0.2, 0.3, 1.6, 0.5, 0, 0, 0, 1};
    b.shape(SphereDesc{0.5}, b.material(ConductorMaterial{}), sheared);
    const Sphere sphere = casters_of(b.scene().shapes[0], b.scene(), {}).at(0);
    double farthest = 0;
    Rng rng(91, 0, 0);
    for (int i = 0; i < 10'000; ++i) {
        const Vec3 p = Transform(sheared).point(sample_uniform_sphere(rng.next_2d()) * 0.5);
        farthest = std::max(farthest, length(p - sphere.center));
    }
    EXPECT_LE(farthest, sphere.radius);
    EXPECT_GE(farthest, sphere.radius * 0.75);
}

/// Only the faces whose material gathers light count.
TEST(Casters, PartOfAMesh) {
    test::SceneBuilder b;
    const int glass = b.material(DielectricMaterial{});
    MeshDesc mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 0, 0}, {10, 0, 0}, {9, 1, 0}};
    mesh.face_vertex_counts = {3, 3};
    mesh.face_vertex_indices = {0, 1, 2, 3, 4, 5};
    mesh.face_materials = {0, 1};
    b.shape(mesh, glass);
    b.scene().shapes[0].materials = {b.diffuse(0.5), glass};
    const Sphere sphere = casters_of(b.scene().shapes[0], b.scene(), {}).at(0);
    EXPECT_NEAR(length(sphere.center - Vec3{9.5, 0.5, 0}), 0, 1e-6);
    EXPECT_NEAR(sphere.radius, std::sqrt(0.5), 1e-6);
}

/// A group's sphere goes along with its instances; without light subpaths nobody looks for any.
TEST(Casters, InstancesAreAimedAtByLightSubpathsOnly) {
    test::SceneBuilder b;
    b.scene().geometries.emplace_back(SphereDesc{0.5});
    b.scene().groups.push_back({"/Group", {{"/Group/Ball", 0, {b.material(DielectricMaterial{})}, {}}}});
    b.scene().instances.push_back({"/Instance", 0, test::translation({0, 0, -4})});
    b.light(test::point_light({}, 1));
    b.quad({-1, -1, 9}, {2, 0, 0}, {0, 2, 0}, b.diffuse(0.5));  // without it no light subpath could be joined
    const auto boost = [&b](bool light_paths, const Vec3& w) {
        RenderSettings settings;
        if (!light_paths) settings.integrator = IntegratorKind::Path;
        const Requirements needs = find_requirements(b.scene(), settings);
        const Scene scene(b.scene(), {}, {needs});
        const LightPoint y = scene.light(0).sample_emission({}, {}).y;
        return scene.emission().pdf(scene.light(0), y, w, w).pdf_dir / scene.light(0).pdf_emission(y, w).pdf_dir;
    };
    EXPECT_GT(boost(true, {0, 0, -1}), 10);
    EXPECT_LT(boost(true, {0, 0, 1}), 1);
    EXPECT_EQ(boost(false, {0, 0, -1}), 1);
}

TEST(Casters, ClustersHoldAllOfThem) {
    Rng rng(92, 0, 0);
    for (const int count : {1, 5, 40, 1000}) {
        std::vector<Sphere> spheres;
        for (int i = 0; i < count; ++i) {
            const Vec2 xy = rng.next_2d();
            spheres.push_back({Vec3{xy.x, xy.y, rng.next_1d()} * 10, 0.1 * rng.next_1d() + 0.01});
        }
        const std::vector<Sphere> clusters = cluster(spheres, 6);
        EXPECT_LE(clusters.size(), 6);
        for (const Sphere& s : spheres) {
            bool held = false;
            for (const Sphere& c : clusters) held = held || length(s.center - c.center) + s.radius <= c.radius + 1e-9;
            ASSERT_TRUE(held) << count;
        }
    }
    EXPECT_TRUE(cluster({}, 6).empty());
}

TEST(Casters, GroupsFarApartStayApart) {
    std::vector<Sphere> spheres;
    for (const double x : {0.0, 100.0, 200.0}) {
        for (int i = 0; i < 4; ++i) spheres.push_back({{x + 0.1 * i, 0, 0}, 0.2});
    }
    const std::vector<Sphere> clusters = cluster(spheres, 6);
    EXPECT_EQ(clusters.size(), 3);
    for (const Sphere& c : clusters) EXPECT_LT(c.radius, 1);
}

}  // namespace
}  // namespace etendue
