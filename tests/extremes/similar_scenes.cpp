#include "extremes/similar_scenes.h"

#include <variant>

namespace etendue::test {
namespace {

void scale_matrix(Matrix4& matrix, double scale) {
    for (std::size_t i = 0; i < 12; ++i) matrix.m[i] *= scale;
}

void move_matrix(Matrix4& matrix, const Vec3& offset) {
    for (std::size_t axis = 0; axis < 3; ++axis) matrix.m[4 * axis + 3] += offset[static_cast<int>(axis)];
}

template <typename Change>
void change_placements(SceneDescription& scene, const Change& change) {
    for (ShapeDesc& shape : scene.shapes) change(shape.parent_from_object);
    for (InstanceDesc& instance : scene.instances) change(instance.world_from_group);
    for (LightDesc& light : scene.lights) change(light.world_from_light);
    for (CameraDesc& camera : scene.cameras) change(camera.world_from_camera);
}

/// Whether `intensity` is a power or an intensity, not a radiance or an irradiance.
bool authored_as_power(const LightDesc& light) {
    const bool area = light.kind != LightKind::Distant && light.kind != LightKind::Dome;
    return area && (light.normalize || light.radius == 0);
}

void scale_lens(CameraDesc& camera, double scale) {
    if (camera.projection == CameraProjection::Orthographic) {
        camera.horizontal_aperture *= scale;
        camera.vertical_aperture *= scale;
    }
    camera.focus_distance *= scale;
    camera.f_stop /= scale;
}

void scale_depth(MaterialDesc& material, double scale) {
    if (auto* glass = std::get_if<DielectricMaterial>(&material.model)) glass->transmission_depth *= scale;
}

}  // namespace

SceneDescription scaled(SceneDescription scene, double scale) {
    change_placements(scene, [scale](Matrix4& matrix) { scale_matrix(matrix, scale); });
    for (LightDesc& light : scene.lights) {
        if (authored_as_power(light)) light.intensity *= scale * scale;
    }
    for (CameraDesc& camera : scene.cameras) scale_lens(camera, scale);
    for (MaterialDesc& material : scene.materials) scale_depth(material, scale);
    return scene;
}

SceneDescription moved(SceneDescription scene, const Vec3& offset) {
    change_placements(scene, [&offset](Matrix4& matrix) { move_matrix(matrix, offset); });
    return scene;
}

SceneDescription moved_within_groups(SceneDescription scene, const Vec3& offset) {
    for (GroupDesc& group : scene.groups) {
        for (ShapeDesc& shape : group.shapes) move_matrix(shape.parent_from_object, offset);
    }
    for (InstanceDesc& instance : scene.instances) {
        const auto& m = instance.world_from_group.m;
        const auto row = [&](std::size_t i) { return m[i] * offset.x + m[i + 1] * offset.y + m[i + 2] * offset.z; };
        move_matrix(instance.world_from_group, -Vec3{row(0), row(4), row(8)});
    }
    return scene;
}

}  // namespace etendue::test
