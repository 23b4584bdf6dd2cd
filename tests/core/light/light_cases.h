#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "core/light/memory_image.h"
#include "light/make_light.h"

namespace etendue::test {

inline Matrix4 matrix(std::array<double, 9> linear, Vec3 translation = {}) {
    Matrix4 m;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) m.m[4 * row + column] = linear[3 * row + column];
        m.m[4 * row + 3] = translation[static_cast<int>(row)];
    }
    return m;
}
inline Matrix4 scaling(double x, double y, double z, Vec3 translation = {}) {
    return matrix({x, 0, 0, 0, y, 0, 0, 0, z}, translation);
}
/// A rotation with 2/3, 1/3 entries: exact to a rounding, no axis fixed.
inline Matrix4 rotated(double scale, Vec3 translation = {}) {
    const double a = scale / 3;
    return matrix({2 * a, -2 * a, a, a, 2 * a, 2 * a, -2 * a, -a, 2 * a}, translation);
}
/// Sheared, stretched, off the origin; mirrored when `sign` is -1.
inline Matrix4 general(double sign = 1) {
    return matrix({1.2 * sign, 0.4, -0.3, 0.1 * sign, 0.7, 0.5, -0.2 * sign, 0.3, 1.6}, {0.3, -0.2, 0.5});
}

inline constexpr SceneBounds kBounds{{0.5, -0.25, 1}, 6};

inline LightDesc light_desc(LightKind kind, const Matrix4& world_from_light = {}) {
    LightDesc light;
    light.name = "/test/light";
    light.kind = kind;
    light.world_from_light = world_from_light;
    light.intensity = 2;
    light.exposure = 0.5;
    light.color = {0.9, 0.5, 0.25};
    light.width = 1.5;
    light.height = 0.8;
    light.length = 1.1;
    light.radius = 0.6;
    return light;
}

/// Front faces outward.
inline std::vector<LightTriangle> tetrahedron() {
    const Vec3 a{0, 0, 0};
    const Vec3 b{1, 0, 0};
    const Vec3 c{0, 1.5, 0};
    const Vec3 d{0.2, 0.3, 2};
    const auto face = [](Vec3 p, Vec3 q, Vec3 r) {
        return LightTriangle{{p, q, r}, {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}}};
    };
    return {face(a, c, b), face(a, b, d), face(b, c, d), face(c, a, d)};
}

/// Brighter towards s = 1, with a colour that depends on t.
class RampTexture final : public EmissionTexture {
public:
    [[nodiscard]] Rgb at(const Vec2& st) const override { return {1 + st.x, 0.5, 0.25 + st.y}; }
};

inline std::shared_ptr<const Light> image_dome() {
    const LightDesc desc = light_desc(LightKind::Dome, rotated(2));
    return make_light(desc, kBounds, std::make_shared<MemoryImage>(mottled_image(16, 8, true)));
}

/// A light and, of a surface, where its points are.
struct LightCase {
    std::string name;
    std::shared_ptr<const Light> light;
    std::vector<LightTriangle> triangles;
    std::optional<Quadric> quadric;
    Vec3 axis{0, 0, -1};  ///< of light space, in the world; not unit
};

/// How a failing test shows its case.
inline void PrintTo(const LightCase& light_case, std::ostream* out) { *out << light_case.name; }

inline std::string case_name(const testing::TestParamInfo<LightCase>& param) {
    std::string name = param.param.name;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

inline LightCase light_case(std::string name, const LightDesc& desc) {
    LightCase result{std::move(name), make_light(desc, kBounds), {}, {}};
    result.axis = Transform(desc.world_from_light).vector({0, 0, -1});
    const std::optional<LightShape> shape = make_light_shape(desc);
    if (!shape) return result;
    if (const auto* quadric = std::get_if<Quadric>(&*shape)) {
        result.quadric = *quadric;
        return result;
    }
    const auto& mesh = std::get<TriangleMesh>(*shape);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const bool flip = mesh.outward < 0;
        result.triangles.push_back({{mesh.point(t, 0), mesh.point(t, flip ? 2 : 1), mesh.point(t, flip ? 1 : 2)}, {}});
    }
    return result;
}

inline LightCase mesh_case(std::string name, std::shared_ptr<const EmissionTexture> texture) {
    return {std::move(name),
            make_mesh_light(light_desc(LightKind::Mesh), tetrahedron(), std::move(texture)),
            tetrahedron(),
            {}};
}

inline std::vector<LightCase> surface_lights() {
    std::vector<LightCase> cases;
    for (const auto& [kind, name] :
         {std::pair{LightKind::Rect, "Rect"}, std::pair{LightKind::Disk, "Disk"},
          std::pair{LightKind::Sphere, "Sphere"}, std::pair{LightKind::Cylinder, "Cylinder"}}) {
        cases.push_back(light_case(name, light_desc(kind)));
        cases.push_back(light_case(name + std::string("Rotated"), light_desc(kind, rotated(1.5, {0.3, 0.2, -0.4}))));
        cases.push_back(light_case(name + std::string("General"), light_desc(kind, general())));
        cases.push_back(light_case(name + std::string("Mirrored"), light_desc(kind, general(-1))));
    }
    cases.push_back(light_case("SphereFlat", light_desc(LightKind::Sphere, scaling(1, 1.3, 0.05))));
    cases.push_back(light_case("SphereLong", light_desc(LightKind::Sphere, scaling(4, 0.2, 0.3))));
    cases.push_back(mesh_case("Mesh", nullptr));
    cases.push_back(mesh_case("MeshTextured", std::make_shared<RampTexture>()));
    return cases;
}

inline std::vector<LightCase> infinite_lights() {
    std::vector<LightCase> cases;
    for (const double angle : {1e-3, 0.53, 60.0, 250.0, 360.0}) {
        LightDesc light = light_desc(LightKind::Distant, rotated(2));
        light.angle = angle;
        std::string name = "Distant" + std::to_string(angle);
        name.resize(name.find('.') + 3);
        cases.push_back(light_case(name, light));
    }
    cases.push_back(light_case("Dome", light_desc(LightKind::Dome)));
    return cases;
}

inline std::vector<LightCase> delta_lights() {
    LightDesc point = light_desc(LightKind::Sphere, rotated(1.5, {0.3, 0.2, -0.4}));
    point.treat_as_point = true;
    LightDesc zero = point;
    zero.radius = 0;
    LightDesc sun = light_desc(LightKind::Distant, rotated(2));
    sun.angle = 0;
    LightDesc line = light_desc(LightKind::Cylinder, rotated(1.5, {0.3, 0.2, -0.4}));
    line.treat_as_line = true;
    return {light_case("Point", point), light_case("PointOfNoRadius", zero), light_case("DistantDelta", sun),
            light_case("Line", line)};
}

inline LightDesc shaped(LightDesc desc, double cone_angle, double softness, double focus) {
    desc.shaping = ShapingDesc{focus, {0, 0.3, 0.1}, cone_angle, softness};
    return desc;
}

/// A texture on a rect, upright as the light's own.
inline LightCase image_rect(const std::string& name, const LightDesc& desc) {
    LightCase result = light_case(name, desc);
    result.light = make_light(desc, kBounds, std::make_shared<MemoryImage>(mottled_image(8, 4, false)));
    return result;
}

/// Beams narrow and wide, with soft and hard edges, about the normal and not.
inline std::vector<LightCase> shaped_lights() {
    const Matrix4 turned = rotated(1.5, {0.3, 0.2, -0.4});
    std::vector<LightCase> cases;
    for (const auto& [kind, name] :
         {std::pair{LightKind::Rect, "Rect"}, std::pair{LightKind::Disk, "Disk"},
          std::pair{LightKind::Sphere, "Sphere"}, std::pair{LightKind::Cylinder, "Cylinder"}}) {
        const std::string title = name;
        cases.push_back(light_case(title + "Spot", shaped(light_desc(kind, turned), 5, 0, 0)));
        cases.push_back(light_case(title + "Soft", shaped(light_desc(kind), 50, 0.6, 3)));
        cases.push_back(light_case(title + "Focus", shaped(light_desc(kind, turned), 180, 0, 12)));
        cases.push_back(light_case(title + "Sheared", shaped(light_desc(kind, general(-1)), 120, 0.5, 1)));
    }
    LightDesc point = light_desc(LightKind::Sphere, turned);
    point.treat_as_point = true;
    LightDesc line = light_desc(LightKind::Cylinder, turned);
    line.treat_as_line = true;
    for (const double angle : {5.0, 60.0, 150.0}) {
        const std::string title = std::to_string(static_cast<int>(angle));
        cases.push_back(light_case("Point" + title, shaped(point, angle, 0.3, 0)));
        cases.push_back(light_case("Line" + title, shaped(line, angle, 0.3, 2)));
    }
    cases.push_back(image_rect("RectImageSpot", shaped(light_desc(LightKind::Rect, turned), 20, 0.2, 0)));
    LightCase mesh = mesh_case("MeshSpot", std::make_shared<RampTexture>());
    mesh.light =
        make_mesh_light(shaped(light_desc(LightKind::Mesh), 70, 0, 0), tetrahedron(), std::make_shared<RampTexture>());
    cases.push_back(mesh);
    return cases;
}

inline std::vector<LightCase> all_lights() {
    std::vector<LightCase> cases = surface_lights();
    for (const auto& other : {infinite_lights(), delta_lights()}) cases.insert(cases.end(), other.begin(), other.end());
    cases.push_back({"DomeImage", image_dome(), {}, {}});
    cases.push_back(image_rect("RectImage", light_desc(LightKind::Rect, rotated(1.5, {0.3, 0.2, -0.4}))));
    return cases;
}

/// The beams too, of whose samples some carry nothing.
inline std::vector<LightCase> all_lights_and_beams() {
    std::vector<LightCase> cases = all_lights();
    for (const LightCase& beam : shaped_lights()) cases.push_back(beam);
    return cases;
}

}  // namespace etendue::test
