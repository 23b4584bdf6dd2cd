#include "support/scene_builder.h"

#include <cmath>

#include "math/constants.h"
#include "math/frame.h"

namespace etendue::test {
namespace {

Float3 to_float3(const Vec3& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

}  // namespace

Matrix4 translation(const Vec3& t) { return {{1, 0, 0, t.x, 0, 1, 0, t.y, 0, 0, 1, t.z, 0, 0, 0, 1}}; }

Matrix4 look_at(const Vec3& from, const Vec3& to) {
    const Vec3 back = normalize(from - to);
    const Vec3 up = std::abs(back.y) > 0.99 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
    const Vec3 x = normalize(cross(up, back));
    const Vec3 y = cross(back, x);
    return {{x.x, y.x, back.x, from.x, x.y, y.y, back.y, from.y, x.z, y.z, back.z, from.z, 0, 0, 0, 1}};
}

MeshDesc low_polygon_sphere(int columns, int rows, bool smooth) {
    MeshDesc mesh;
    for (int row = 0; row <= rows; ++row) {
        const double latitude = kPi * row / rows - kPi / 2;
        const double r = row == 0 || row == rows ? 0 : std::cos(latitude);
        for (int column = 0; column < columns; ++column) {
            const double longitude = 2 * kPi * column / columns;
            const Vec3 p{r * std::cos(longitude), r * std::sin(longitude), std::sin(latitude)};
            mesh.points.push_back(to_float3(p));
            if (smooth) mesh.normals.push_back(to_float3(p));
        }
    }
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int next = (column + 1) % columns;
            const int a = row * columns;
            const int b = a + columns;
            if (row == 0) {
                mesh.face_vertex_counts.push_back(3);
                mesh.face_vertex_indices.insert(mesh.face_vertex_indices.end(), {a, b + next, b + column});
            } else if (row == rows - 1) {
                mesh.face_vertex_counts.push_back(3);
                mesh.face_vertex_indices.insert(mesh.face_vertex_indices.end(), {a + column, a + next, b});
            } else {
                mesh.face_vertex_counts.push_back(4);
                mesh.face_vertex_indices.insert(mesh.face_vertex_indices.end(),
                                                {a + column, a + next, b + next, b + column});
            }
        }
    }
    return mesh;
}

LightDesc point_light(const Vec3& p, double intensity) {
    LightDesc light;
    light.name = "/point";
    light.kind = LightKind::Sphere;
    light.radius = 0;
    light.intensity = intensity;
    light.normalize = true;
    light.world_from_light = translation(p);
    return light;
}

int SceneBuilder::material(const MaterialModel& model, const Color& emission) {
    MaterialDesc desc;
    desc.name = "/material_" + std::to_string(scene_.materials.size());
    desc.model = model;
    desc.emission.value = emission;
    scene_.materials.push_back(desc);
    return static_cast<int>(scene_.materials.size()) - 1;
}

int SceneBuilder::diffuse(double reflectance) {
    return material(DiffuseMaterial{{{reflectance, reflectance, reflectance}}});
}

int SceneBuilder::shape(const GeometryDesc& geometry, int material, const Matrix4& world_from_object) {
    ShapeDesc shape;
    shape.name = "/shape_" + std::to_string(scene_.shapes.size());
    shape.geometry = static_cast<int>(scene_.geometries.size());
    shape.materials = {material};
    shape.parent_from_object = world_from_object;
    scene_.geometries.emplace_back(geometry);
    scene_.shapes.push_back(shape);
    return static_cast<int>(scene_.shapes.size()) - 1;
}

int SceneBuilder::quad(const Vec3& corner, const Vec3& u, const Vec3& v, int material) {
    MeshDesc mesh;
    mesh.points = {to_float3(corner), to_float3(corner + u), to_float3(corner + u + v), to_float3(corner + v)};
    mesh.st = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.face_vertex_counts = {4};
    mesh.face_vertex_indices = {0, 1, 2, 3};
    return shape(mesh, material);
}

int SceneBuilder::sphere(const Vec3& center, double radius, int material) {
    return shape(SphereDesc{radius}, material, translation(center));
}

void SceneBuilder::open_box(int material) {
    quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, material);  // back
    quad({-1, -1, -1}, {0, 0, 2}, {2, 0, 0}, material);  // floor
    quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, material);   // ceiling
    quad({-1, -1, -1}, {0, 2, 0}, {0, 0, 2}, material);  // left
    quad({1, -1, -1}, {0, 0, 2}, {0, 2, 0}, material);   // right
}

int SceneBuilder::light(const LightDesc& light) {
    scene_.lights.push_back(light);
    if (scene_.lights.back().name.empty()) scene_.lights.back().name = "/light_" + std::to_string(scene_.lights.size());
    return static_cast<int>(scene_.lights.size()) - 1;
}

int SceneBuilder::rect_light(const Vec3& center, const Vec3& direction, double width, double height, double intensity) {
    LightDesc desc;
    desc.kind = LightKind::Rect;
    desc.width = width;
    desc.height = height;
    desc.intensity = intensity;
    desc.normalize = true;
    desc.world_from_light = look_at(center, center + direction);
    return light(desc);
}

int SceneBuilder::camera(const Vec3& from, const Vec3& to, double field_of_view_degrees) {
    CameraDesc desc;
    desc.name = "/camera_" + std::to_string(scene_.cameras.size());
    desc.world_from_camera = look_at(from, to);
    desc.horizontal_aperture = 20;
    desc.vertical_aperture = 20;
    desc.focal_length = 10 / std::tan(field_of_view_degrees * kPi / 360);
    scene_.cameras.push_back(desc);
    return static_cast<int>(scene_.cameras.size()) - 1;
}

void SceneBuilder::orthographic(const Vec3& from, const Vec3& to, double width) {
    CameraDesc desc;
    desc.name = "/orthographic";
    desc.projection = CameraProjection::Orthographic;
    desc.world_from_camera = look_at(from, to);
    desc.horizontal_aperture = desc.vertical_aperture = 10 * width;
    scene_.cameras = {desc};
}

void SceneBuilder::lens(double radius, double focus_distance) {
    CameraDesc& desc = scene_.cameras.back();
    desc.f_stop = desc.focal_length / 10 / (2 * radius);
    desc.focus_distance = focus_distance;
}

}  // namespace etendue::test
