#include "scene/world_origin.h"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "geometry/ray.h"
#include "light/usd_lux.h"
#include "math/constants.h"

namespace etendue {
namespace {

struct Box {
    Vec3 lower{kInfinity, kInfinity, kInfinity};
    Vec3 upper{-kInfinity, -kInfinity, -kInfinity};

    void add(const Vec3& p) {
        lower = min(lower, p);
        upper = max(upper, p);
    }
    [[nodiscard]] bool empty() const { return !(lower.x <= upper.x); }
    [[nodiscard]] double width() const { return max_component(upper - lower); }
};

Vec3 place(const Matrix4& matrix, const Vec3& p) {
    const auto& m = matrix.m;
    return Vec3{m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3], m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
                m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]} /
           m[15];
}

void add_placed(const Box& object, const Matrix4& matrix, Box& box) {
    if (object.empty()) return;
    for (int corner = 0; corner < 8; ++corner) {
        const auto& [l, u] = object;
        box.add(place(matrix,
                      {(corner & 1) != 0 ? u.x : l.x, (corner & 2) != 0 ? u.y : l.y, (corner & 4) != 0 ? u.z : l.z}));
    }
}

Box about_origin(double half_width) {
    return {{-half_width, -half_width, -half_width}, {half_width, half_width, half_width}};
}

Box extent(const MeshDesc& mesh) {
    Box box;
    for (const Float3& p : mesh.points) box.add(Vec3{p});
    return box;
}
Box extent(const SphereDesc& sphere) { return about_origin(sphere.radius); }
Box extent(const CubeDesc& cube) { return about_origin(cube.size / 2); }
Box extent(const PlaneDesc& plane) { return about_origin(std::max(plane.width, plane.length) / 2); }
template <typename Revolved>
Box extent(const Revolved& body) {
    return about_origin(body.radius + body.height / 2);
}

void add_shapes(const std::vector<ShapeDesc>& shapes, const std::vector<Box>& geometries, Box& box) {
    for (const ShapeDesc& shape : shapes) {
        const auto geometry = static_cast<std::size_t>(shape.geometry);
        if (geometry < geometries.size()) add_placed(geometries[geometry], shape.parent_from_object, box);
    }
}

void add_instances(const SceneDescription& scene, const std::vector<Box>& groups, Box& box) {
    for (const InstanceDesc& instance : scene.instances) {
        const auto group = static_cast<std::size_t>(instance.group);
        if (group < groups.size()) add_placed(groups[group], instance.world_from_group, box);
    }
}

/// By their places: a lamp is not what a scene's size is measured by.
void add_lights(const SceneDescription& scene, Box& box) {
    for (const LightDesc& light : scene.lights) {
        if (lux_has_place(light)) box.add(place(light.world_from_light, {}));
    }
}

Vec3 origin_next_to(const Box& box) {
    if (!(box.width() > 0)) return {};  // a camera alone: there is nothing to be near to
    const double step = std::exp2(std::ceil(std::log2(box.width())) + 1);
    const Vec3 center = (box.lower + box.upper) * 0.5;
    const Vec3 origin =
        Vec3{std::round(center.x / step), std::round(center.y / step), std::round(center.z / step)} * step;
    // Otherwise what lies out of reach is complained of by its own name.
    return is_finite(origin) && within_reach(origin) ? origin : Vec3{};
}

}  // namespace

Origins find_origins(const SceneDescription& scene, const CameraDesc& camera) {
    std::vector<Box> geometries;
    for (const SharedGeometry& geometry : scene.geometries) {
        geometries.push_back(std::visit([](const auto& g) { return extent(g); }, *geometry));
    }
    std::vector<Box> groups;
    for (const GroupDesc& group : scene.groups) add_shapes(group.shapes, geometries, groups.emplace_back());
    Box box;
    add_shapes(scene.shapes, geometries, box);
    add_instances(scene, groups, box);
    if (!(box.width() > 0)) add_lights(scene, box);
    if (!(box.width() > 0)) box.add(place(camera.world_from_camera, {}));
    Origins origins{origin_next_to(box), {}};
    for (const Box& group : groups) origins.groups.push_back(origin_next_to(group));
    return origins;
}

Matrix4 relative_to(const Vec3& origin, Matrix4 world_from_object) {
    auto& m = world_from_object.m;
    m[3] -= origin.x * m[15];
    m[7] -= origin.y * m[15];
    m[11] -= origin.z * m[15];
    return world_from_object;
}

Matrix4 measured_from(const Vec3& origin, Matrix4 world_from_object) {
    auto& m = world_from_object.m;
    m[3] += m[0] * origin.x + m[1] * origin.y + m[2] * origin.z;
    m[7] += m[4] * origin.x + m[5] * origin.y + m[6] * origin.z;
    m[11] += m[8] * origin.x + m[9] * origin.y + m[10] * origin.z;
    return world_from_object;
}

}  // namespace etendue
