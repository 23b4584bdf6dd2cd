#include "light/make_light.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <etendue/error.h>

#include "geometry/ray.h"
#include "light/cylinder_light.h"
#include "light/dark_light.h"
#include "light/disk_light.h"
#include "light/distant_light.h"
#include "light/dome_light.h"
#include "light/latlong_dome_light.h"
#include "light/line_light.h"
#include "light/point_light.h"
#include "light/rect_light.h"
#include "light/sphere_light.h"
#include "light/usd_lux.h"

namespace etendue {
namespace {

[[noreturn]] void fail(const LightDesc& light, const std::string& what) {
    throw SceneError("light '" + light.name + "': " + what);
}

void require_finite(const LightDesc& light, double value, const char* attribute) {
    if (!std::isfinite(value)) fail(light, std::string(attribute) + " is not finite");
}

void require_not_negative(const LightDesc& light, double value, const char* attribute) {
    require_finite(light, value, attribute);
    if (value < 0) fail(light, std::string(attribute) + " is negative");
}

void check_attributes(const LightDesc& light) {
    require_not_negative(light, light.intensity, "intensity");
    require_finite(light, light.exposure, "exposure");
    for (double c : light.color) require_finite(light, c, "color");
    for (double c : light.color_temperature_rgb) require_finite(light, c, "color temperature");
    require_not_negative(light, light.width, "width");
    require_not_negative(light, light.height, "height");
    require_not_negative(light, light.radius, "radius");
    require_not_negative(light, light.length, "length");
    require_finite(light, light.angle, "angle");
    if (!light.shaping) return;
    require_finite(light, light.shaping->focus, "shaping focus");
    for (double c : light.shaping->focus_tint) require_finite(light, c, "shaping focus tint");
    require_finite(light, light.shaping->cone_angle, "shaping cone angle");
    require_finite(light, light.shaping->cone_softness, "shaping cone softness");
}

/// What `make` returns; what it complains of is said of the light.
template <typename Make>
auto naming(const LightDesc& light, Make&& make) {
    try {
        return make();
    } catch (const SceneError& error) {
        fail(light, error.what());
    }
}

Transform checked_transform(const LightDesc& light) {
    check_attributes(light);
    const Transform world_from_light = naming(light, [&light] { return Transform(light.world_from_light); });
    const Vec3 size = max({light.width, light.height, light.length}, {light.radius, light.radius, light.radius});
    if (lux_has_place(light) && !within_reach(world_from_light.magnitude(size))) fail(light, "it reaches too far away");
    return world_from_light;
}

/// Products of more than that, along a path, may be more than a double can hold; and no picture shows it.
Rgb finite(const LightDesc& light, const Rgb& value) {
    if (!std::isfinite(value.r + value.g + value.b)) fail(light, "its radiance is not finite");
    if (max_component(value) > std::numeric_limits<float>::max())
        fail(light, "its radiance is more than a float can hold");
    return value;
}

/// Radiance of a light of that area, which may be zero: such a light is dark, and cannot be normalised.
Rgb surface_radiance(const LightDesc& light, double area) {
    constexpr double kLeastArea = 1e-100;  // weights square densities by area: double must hold that
    if (!std::isfinite(area)) fail(light, "its area is not finite");
    if (area > 0 && area < kLeastArea) fail(light, "it is too small");
    if (area == 0 && light.normalize) fail(light, "it has no area to normalize by");
    if (area == 0) return {};
    return finite(light, lux_radiance(light, lux_area_size_factor(area)));
}

/// The light, shaped if it is authored so. What then emits nothing is dark.
template <typename Shapeable>
std::unique_ptr<Light> shaped(const LightDesc& light, const Transform& world_from_light,
                              std::unique_ptr<Shapeable> plain) {
    if (light.shaping) plain->shape({*light.shaping, normalize(world_from_light.vector({0, 0, -1}))});
    if (is_black(plain->power())) return std::make_unique<DarkLight>();
    return plain;
}

std::unique_ptr<Light> make_rect(const LightDesc& light, const Transform& world_from_light,
                                 std::shared_ptr<const EmissionImage> image) {
    const double area = RectLight::world_area(world_from_light, light.width, light.height);
    const Rgb radiance = surface_radiance(light, area);
    if (area == 0) return std::make_unique<DarkLight>();
    std::optional<RectImage> picture;
    if (image) naming(light, [&] { picture.emplace(std::move(image)); });
    return shaped(
        light, world_from_light,
        std::make_unique<RectLight>(world_from_light, light.width, light.height, radiance, std::move(picture)));
}

std::unique_ptr<Light> make_disk(const LightDesc& light, const Transform& world_from_light) {
    const double area = DiskLight::world_area(world_from_light, light.radius);
    const Rgb radiance = surface_radiance(light, area);
    if (area == 0) return std::make_unique<DarkLight>();
    return shaped(light, world_from_light, std::make_unique<DiskLight>(world_from_light, light.radius, radiance));
}

std::unique_ptr<Light> make_sphere(const LightDesc& light, const Transform& world_from_light) {
    const double area = SphereLight::world_area(world_from_light, light.radius);
    if (lux_is_thin(light)) {
        return shaped(light, world_from_light,
                      std::make_unique<PointLight>(world_from_light.translation(),
                                                   finite(light, lux_point_intensity(light, area))));
    }
    const Rgb radiance = surface_radiance(light, area);
    if (area == 0) return std::make_unique<DarkLight>();
    return shaped(light, world_from_light, std::make_unique<SphereLight>(world_from_light, light.radius, radiance));
}

std::unique_ptr<Light> make_cylinder(const LightDesc& light, const Transform& world_from_light) {
    const double area = CylinderLight::world_area(world_from_light, light.length, light.radius);
    const Vec3 segment = world_from_light.vector({light.length, 0, 0});
    if (light.length == 0) {
        if (light.normalize) fail(light, "it has no length to normalize by");
        return std::make_unique<DarkLight>();
    }
    if (lux_is_thin(light)) {
        return shaped(light, world_from_light,
                      std::make_unique<LineLight>(world_from_light.point({-light.length / 2, 0, 0}), segment,
                                                  finite(light, lux_line_intensity(light, area, length(segment)))));
    }
    const Rgb radiance = surface_radiance(light, area);
    if (area == 0) return std::make_unique<DarkLight>();
    return shaped(light, world_from_light,
                  std::make_unique<CylinderLight>(world_from_light, light.length, light.radius, radiance));
}

std::unique_ptr<Light> make_distant(const LightDesc& light, const Transform& world_from_light,
                                    const SceneBounds& bounds) {
    const Vec3 to_light = normalize(world_from_light.vector({0, 0, 1}));  // it emits along -Z
    const double half_angle = lux_distant_half_angle(light);
    if (half_angle == 0) {
        return std::make_unique<DeltaDistantLight>(bounds, to_light,
                                                   finite(light, lux_delta_distant_irradiance(light)));
    }
    const Rgb radiance = finite(light, lux_radiance(light, lux_distant_size_factor(half_angle)));
    return std::make_unique<DistantLight>(bounds, to_light, half_angle, radiance);
}

std::unique_ptr<Light> make_dome(const LightDesc& light, const Transform& world_from_light, const SceneBounds& bounds,
                                 std::shared_ptr<const EmissionImage> image) {
    const Rgb radiance = finite(light, lux_dome_radiance(light));
    if (!image) return std::make_unique<DomeLight>(bounds, radiance);
    if (light.pole_axis == Axis::X) fail(light, "a dome's pole axis is Y or Z");
    std::unique_ptr<Light> dome = naming(light, [&] {
        return std::make_unique<LatlongDomeLight>(bounds, lux_dome_frame(light, world_from_light), radiance,
                                                  std::move(image));
    });
    if (is_black(dome->power())) return std::make_unique<DarkLight>();
    return dome;
}

TriangleMesh rect_shape(const LightDesc& light, const Transform& world_from_light) {
    const auto x = static_cast<float>(light.width / 2);
    const auto y = static_cast<float>(light.height / 2);
    MeshDesc quad;  // counter-clockwise as seen from -Z
    quad.points = {{-x, -y, 0}, {-x, y, 0}, {x, y, 0}, {x, -y, 0}};
    if (lux_texture(light)) quad.st = {{1, 0}, {1, 1}, {0, 1}, {0, 0}};
    quad.face_vertex_counts = {4};
    quad.face_vertex_indices = {0, 1, 2, 3};
    return make_triangle_mesh(quad, world_from_light, "light '" + light.name + "'");
}

}  // namespace

std::optional<LightShape> make_light_shape(const LightDesc& light) {
    const Transform world_from_light = checked_transform(light);
    switch (light.kind) {
        case LightKind::Rect:
            if (light.width == 0 || light.height == 0) return {};
            return rect_shape(light, world_from_light);
        case LightKind::Disk:
            if (light.radius == 0) return {};
            return Quadric{QuadricKind::Disk, light.radius, true, world_from_light};  // emits along -Z
        case LightKind::Sphere:
            if (lux_is_thin(light)) return {};
            return Quadric{QuadricKind::Sphere, light.radius, false, world_from_light};
        case LightKind::Cylinder:
            if (lux_is_thin(light) || light.length == 0) return {};
            return Quadric{QuadricKind::Tube, light.radius, false, world_from_light, light.length / 2};
        case LightKind::Distant:
        case LightKind::Dome:
        case LightKind::Mesh:
            break;
    }
    return {};
}

std::unique_ptr<Light> make_light(const LightDesc& light, const SceneBounds& bounds,
                                  std::shared_ptr<const EmissionImage> image) {
    const Transform world_from_light = checked_transform(light);
    switch (light.kind) {
        case LightKind::Rect:
            return make_rect(light, world_from_light, std::move(image));
        case LightKind::Disk:
            return make_disk(light, world_from_light);
        case LightKind::Sphere:
            return make_sphere(light, world_from_light);
        case LightKind::Cylinder:
            return make_cylinder(light, world_from_light);
        case LightKind::Distant:
            return make_distant(light, world_from_light, bounds);
        case LightKind::Dome:
            return make_dome(light, world_from_light, bounds, std::move(image));
        case LightKind::Mesh:
            break;
    }
    fail(light, "a mesh light needs a mesh");
}

std::unique_ptr<Light> make_mesh_light(const LightDesc& light, std::vector<LightTriangle> triangles,
                                       std::shared_ptr<const EmissionTexture> tint, std::optional<double> whole_area) {
    const Transform world_from_light = checked_transform(light);
    const double area = MeshLight::world_area(triangles);
    const Rgb radiance = surface_radiance(light, whole_area.value_or(area));
    if (area == 0) return std::make_unique<DarkLight>();
    return shaped(light, world_from_light,
                  std::make_unique<MeshLight>(std::move(triangles), radiance, std::move(tint)));
}

}  // namespace etendue
