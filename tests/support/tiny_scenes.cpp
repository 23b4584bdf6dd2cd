#include "support/tiny_scenes.h"

#include <cmath>

#include <functional>
#include <string>

#include "core/io/temporary_directory.h"
#include "support/hdr_file.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

/// Box, camera and a lamp of the given size under the ceiling.
SceneBuilder lit_box(double lamp_size) {
    SceneBuilder b;
    b.open_box(b.diffuse(0.6));
    b.rect_light({0.1, 0.95, 0}, {0, -1, 0}, lamp_size, lamp_size, 4);
    b.camera({0.1, 0.1, 3.8}, {0, 0, 0}, 36);
    return b;
}

DielectricMaterial glass(double roughness) {
    DielectricMaterial m;
    m.roughness.value = roughness;
    return m;
}

}  // namespace

SceneDescription diffuse_box() {
    SceneBuilder b = lit_box(0.6);
    b.shape(CubeDesc{0.8}, b.diffuse(0.8), translation({-0.3, -0.6, -0.2}));
    return b.scene();
}

SceneDescription indirect_box() {
    SceneBuilder b;
    b.open_box(b.diffuse(0.6));
    b.rect_light({0, 0.3, 0}, {0.1, 1, 0}, 0.5, 0.5, 4);
    b.camera({0.1, 0.1, 3.8}, {0, 0, 0}, 36);
    return b.scene();
}

SceneDescription glossy_box() {
    SceneBuilder b = lit_box(0.7);
    ConductorMaterial metal;
    metal.roughness.value = 0.45;
    b.sphere({-0.45, -0.55, 0}, 0.45, b.material(metal));
    PreviewSurfaceMaterial plastic;
    plastic.diffuse_color.value = {0.2, 0.5, 0.7};
    plastic.roughness.value = 0.4;
    b.sphere({0.5, -0.5, 0.1}, 0.5, b.material(plastic));
    return b.scene();
}

SceneDescription phong_box() {
    SceneBuilder b = lit_box(0.7);
    PhongMaterial phong;
    phong.reflectance.value = {0.8, 0.7, 0.5};
    phong.exponent.value = 6;
    phong.form = PhongForm::Classic;
    b.shape(CubeDesc{0.8}, b.material(phong), translation({-0.45, -0.6, -0.2}));
    phong.exponent.value = 15;
    b.sphere({0.5, -0.5, 0.1}, 0.5, b.material(phong));
    return b.scene();
}

SceneDescription layered_box() {
    SceneBuilder b = lit_box(0.7);
    OpenPbrMaterial coated;
    coated.base_color.value = {0.9, 0.6, 0.3};
    coated.base_diffuse_roughness.value = 1;
    coated.base_metalness.value = 0.5;
    coated.specular_roughness.value = 0.7;
    coated.coat_weight.value = 1;
    coated.coat_roughness.value = 0.4;
    b.sphere({-0.45, -0.55, 0}, 0.45, b.material(coated));
    DielectricMaterial pane = glass(0.7);
    pane.thin_walled = true;
    b.quad({0.1, -1, 0.4}, {0.8, 0, -0.5}, {0, 1.2, 0}, b.material(pane));
    return b.scene();
}

SceneDescription glass_box() {
    SceneBuilder b = lit_box(1.2);
    b.sphere({0, -0.3, 0}, 0.55, b.material(glass(0)));
    return b.scene();
}

SceneDescription rough_glass_box() {
    SceneBuilder b = lit_box(1.0);
    b.sphere({0, -0.3, 0}, 0.55, b.material(glass(0.5)));
    return b.scene();
}

SceneDescription mirror_box() {
    SceneBuilder b = lit_box(1.2);
    b.sphere({0, -0.3, 0}, 0.55, b.material(ConductorMaterial{}));
    return b.scene();
}

SceneDescription smooth_normals_box() {
    SceneBuilder b = lit_box(0.6);
    Matrix4 half = translation({0, -0.3, 0});
    half.m[0] = half.m[5] = half.m[10] = 0.65;
    b.shape(low_polygon_sphere(8, 5, true), b.diffuse(0.8), half);
    return b.scene();
}

SceneDescription sky() {
    SceneBuilder b;
    b.quad({-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, b.diffuse(0.5));
    b.sphere({0, 0.6, 0}, 0.6, b.material(glass(0)));
    LightDesc dome;
    dome.kind = LightKind::Dome;
    dome.intensity = 0.5;
    dome.color = {0.6, 0.8, 1};
    b.light(dome);
    LightDesc sun;
    sun.kind = LightKind::Distant;
    sun.angle = 30;
    sun.intensity = 3;
    sun.normalize = true;
    sun.world_from_light = look_at({2, 3, 1}, {0, 0, 0});
    b.light(sun);
    b.camera({0, 2, 5}, {0, 0.4, 0}, 40);
    return b.scene();
}

SceneDescription image_sky() {
    // Files stay as long as the program: scenes are read after they have been described.
    static const TemporaryDirectory directory;
    const std::string file = directory.file("sky.hdr");
    write_hdr(file, 16, 8, [](int x, int y) {
        if (x == 5 && y == 2) return Rgb(64);
        return y < 4 ? Rgb(0.25, 0.5, 1) : Rgb(0.125, 0.0625, 0);
    });
    SceneBuilder b;
    b.quad({-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, b.diffuse(0.5));
    b.sphere({0, 0.6, 0}, 0.6, b.diffuse(0.8));
    LightDesc dome;
    dome.kind = LightKind::Dome;
    dome.texture_file = file;
    dome.world_from_light = look_at({0, 0, 0}, {0.6, 0.2, 1});
    b.light(dome);
    b.camera({0, 2, 5}, {0, 0.8, 0}, 40);
    return b.scene();
}

SceneDescription shaped_lights() {
    static const TemporaryDirectory directory;
    const std::string file = directory.file("screen.hdr");
    write_hdr(file, 4, 2, [](int x, int y) { return x == 1 && y == 0 ? Rgb(4, 2, 1) : Rgb(0.25, 0.25, 0.5); });
    SceneBuilder b;
    b.open_box(b.diffuse(0.5));
    const auto add = [&b](LightKind kind, const Vec3& from, const Vec3& to, double intensity) {
        LightDesc light;
        light.kind = kind;
        light.width = light.height = 0.4;
        light.radius = kind == LightKind::Cylinder ? 0.08 : 0.15;
        light.length = 0.6;
        light.intensity = intensity;
        light.world_from_light = look_at(from, to);
        b.light(light);
        return std::ref(b.scene().lights.back());
    };
    add(LightKind::Rect, {0, 0.6, -0.9}, {0, 0.5, 0}, 4).get().texture_file = file;
    add(LightKind::Cylinder, {-0.5, -0.3, 0.2}, {-0.2, -1, 0}, 3);
    add(LightKind::Disk, {0.6, 0.8, 0}, {0.3, -1, 0}, 30).get().shaping = ShapingDesc{0, {}, 20, 0.3};
    add(LightKind::Sphere, {-0.6, 0.7, 0}, {-1, 0, 0}, 8).get().shaping = ShapingDesc{4, {0.2, 0, 0}, 60, 0};
    LightDesc spot = point_light({0.2, 0.1, 0.3}, 12);
    spot.world_from_light = look_at({0.2, 0.1, 0.3}, {0.6, -1, -0.4});
    spot.shaping = ShapingDesc{0, {}, 30, 0.5};
    b.light(spot);
    LightDesc line = point_light({}, 1);
    line.kind = LightKind::Cylinder;
    line.world_from_light = look_at({0.7, -0.6, 0.2}, {0, 0, 0});
    b.light(line);
    b.camera({0.1, 0.1, 3.8}, {0, 0, 0}, 36);
    return b.scene();
}

SceneDescription many_lights() {
    SceneBuilder b;
    b.open_box(b.diffuse(0.5));
    b.rect_light({-0.5, 0.9, 0}, {0, -1, 0}, 0.3, 0.4, 1);
    LightDesc disk;
    disk.kind = LightKind::Disk;
    disk.radius = 0.25;
    disk.intensity = 3;
    disk.world_from_light = look_at({0.9, 0, 0}, {0, 0, 0});
    b.light(disk);
    LightDesc ball;
    ball.kind = LightKind::Sphere;
    ball.radius = 0.15;
    ball.intensity = 4;
    ball.world_from_light = translation({0.3, -0.4, 0.3});
    b.light(ball);
    LightDesc egg = ball;
    egg.name = "/egg";
    egg.world_from_light = translation({-0.5, -0.3, 0.2});
    egg.world_from_light.m[5] = 2;
    b.light(egg);
    Matrix4 small = translation({0.2, 0.5, -0.3});
    small.m[0] = small.m[5] = small.m[10] = 0.15;
    const int glow = b.material(DiffuseMaterial{}, {2, 1, 0.5});
    b.shape(low_polygon_sphere(6, 4, false), glow, small);
    b.camera({0.1, 0.1, 3.8}, {0, 0, 0}, 36);
    return b.scene();
}

SceneDescription aimed_lights() {
    SceneBuilder b = lit_box(0.6);
    const int frosted = b.material(glass(0.3));
    b.sphere({-0.6, -0.5, 0}, 0.2, frosted);
    b.sphere({0.6, -0.2, 0.2}, 0.15, frosted);
    LightDesc ball;
    ball.kind = LightKind::Sphere;
    ball.radius = 0.2;
    ball.intensity = 2;
    ball.world_from_light = translation({-0.1, -0.1, -0.3});
    b.light(ball);
    LightDesc sun;
    sun.kind = LightKind::Distant;
    sun.angle = 40;
    sun.intensity = 1.5;
    sun.normalize = true;
    sun.world_from_light = look_at({0.5, 1, 3}, {0, 0, 0});
    b.light(sun);
    return b.scene();
}

SceneDescription light_crowd() {
    SceneBuilder b;
    b.open_box(b.diffuse(0.5));
    // Spread evenly by the golden ratio's kin, facing everywhere, of powers apart by two orders.
    const auto spread = [](int i, double step) { return std::fmod(0.5 + i * step, 1.0); };
    for (int i = 0; i < 300; ++i) {
        const Vec3 center = Vec3{spread(i, 0.8191725), spread(i, 0.6710436), spread(i, 0.5497005)} * 1.8;
        const Vec3 direction{std::cos(i * 2.4), std::sin(i * 2.4), std::cos(i * 1.7)};
        b.rect_light(center - Vec3{0.9, 0.9, 0.9}, direction, 0.04, 0.04, 0.02 * std::exp2(i % 7 - 3));
    }
    LightDesc dome;
    dome.kind = LightKind::Dome;
    dome.intensity = 0.1;
    b.light(dome);
    b.camera({0.1, 0.1, 3.8}, {0, 0, 0}, 36);
    return b.scene();
}

SceneDescription delta_lights() {
    SceneBuilder b;
    b.open_box(b.diffuse(0.6));
    b.light(point_light({0.2, 0.5, 0.2}, 8));
    LightDesc sun;
    sun.kind = LightKind::Distant;
    sun.angle = 0;
    sun.intensity = 2;
    sun.world_from_light = look_at({0.3, 0.5, 3}, {0, 0, 0});
    b.light(sun);
    b.sphere({-0.4, -0.5, 0}, 0.5, b.diffuse(0.8));
    b.camera({0.1, 0.1, 3.8}, {0, 0, 0}, 36);
    return b.scene();
}

SceneDescription lens_box() {
    SceneBuilder b = lit_box(0.6);
    b.sphere({0.4, -0.5, 0.3}, 0.4, b.material(ConductorMaterial{}));
    b.lens(0.4, 3);
    return b.scene();
}

SceneDescription orthographic_box() {
    SceneBuilder b = lit_box(0.6);
    b.shape(CubeDesc{0.8}, b.diffuse(0.8), translation({-0.3, -0.6, -0.2}));
    b.orthographic({0.3, -0.7, 3}, {0, 0, 0}, 2.1);
    return b.scene();
}

SceneDescription orthographic_sky() {
    SceneDescription scene = sky();
    CameraDesc& camera = scene.cameras[0];
    camera.projection = CameraProjection::Orthographic;
    camera.horizontal_aperture = camera.vertical_aperture = 40;
    camera.world_from_camera = look_at({0, 0.8, 5}, {0, 0.6, 0});  // past the plane's edge
    return scene;
}

SceneDescription instanced_box() {
    SceneBuilder b = lit_box(0.6);
    SceneDescription& scene = b.scene();
    const int grey = b.diffuse(0.7);
    const int glow = b.material(DiffuseMaterial{}, {3, 2, 1});
    const int frosted = b.material(glass(0.5));
    GroupDesc group;
    group.name = "/group";
    const auto add = [&](const GeometryDesc& geometry, int material, const Vec3& where, double size) {
        ShapeDesc shape;
        shape.name = "/group/shape_" + std::to_string(group.shapes.size());
        shape.geometry = static_cast<int>(scene.geometries.size());
        shape.materials = {material};
        shape.parent_from_object = translation(where);
        for (std::size_t i : {0U, 5U, 10U}) shape.parent_from_object.m[i] = size;
        scene.geometries.emplace_back(geometry);
        group.shapes.push_back(shape);
    };
    add(CubeDesc{1}, grey, {0, 0, 0}, 0.6);
    add(low_polygon_sphere(6, 4, false), glow, {0.1, 0.5, 0}, 0.15);
    add(SphereDesc{1}, frosted, {0.6, 0, 0.1}, 0.3);
    scene.groups.push_back(group);
    InstanceDesc first{"/first", 0, translation({-0.6, -0.6, 0})};
    InstanceDesc mirrored{"/mirrored", 0, translation({0.55, -0.2, -0.2})};
    mirrored.world_from_group.m[0] = -0.8;
    mirrored.world_from_group.m[5] = 1.2;
    scene.instances = {first, mirrored};
    return b.scene();
}

SceneDescription pool() {
    SceneBuilder b;
    b.open_box(b.diffuse(0.6));
    DielectricMaterial water;
    water.ior = 1.333;
    b.quad({-1, -0.4, 1}, {2, 0, 0}, {0, 0, -2}, b.material(water));
    b.rect_light({0.1, 0.9, 0}, {0, -1, 0}, 0.25, 0.25, 4);
    b.camera({0.1, -0.4, 3.4}, {0, -0.8, 0}, 26);
    return b.scene();
}

SceneDescription coordinate_planes() {
    SceneBuilder b;
    const int glow = b.material(DiffuseMaterial{}, {1, 1, 1});
    b.quad({-1, -1, 0}, {0.8, 0, 0}, {0, 0.8, 0}, glow);
    b.quad({-2, -1, 1}, {0, 0, -2}, {0, 2, 0}, b.diffuse(0.5));
    b.quad({-2, -1, 2}, {4, 0, 0}, {0, 0, -4}, b.diffuse(0.5));
    b.rect_light({0, 0, 0.5}, {0, -1, 0}, 0.6, 0.6, 3);
    b.camera({0.5, 0.3, 4}, {0, -0.4, 0}, 40);
    return b.scene();
}

}  // namespace etendue::test
