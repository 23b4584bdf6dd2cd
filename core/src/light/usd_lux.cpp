#include "light/usd_lux.h"

#include <algorithm>
#include <cmath>

#include "math/constants.h"

namespace etendue {
namespace {

/// The pipeline before any size factor.
Rgb authored_radiance(const LightDesc& light) {
    const Rgb tinted = Rgb(light.color) * Rgb(light.color_temperature_rgb);
    const Rgb positive{std::max(0.0, tinted.r), std::max(0.0, tinted.g), std::max(0.0, tinted.b)};
    return positive * (light.intensity * std::exp2(light.exposure));
}

}  // namespace

Rgb lux_radiance(const LightDesc& light, double size_factor) {
    const Rgb radiance = authored_radiance(light);
    return light.normalize ? radiance / size_factor : radiance;
}

double lux_area_size_factor(double world_area) { return world_area; }

double lux_distant_half_angle(const LightDesc& light) { return std::clamp(light.angle * (kPi / 360), 0.0, kPi); }

double lux_distant_size_factor(double half_angle) {
    if (half_angle == 0) return 1;
    const double sin_t = std::sin(half_angle);
    const double sin2 = sin_t * sin_t;
    return half_angle <= kPi / 2 ? kPi * sin2 : kPi * (2 - sin2);
}

Rgb lux_delta_distant_irradiance(const LightDesc& light) { return authored_radiance(light); }

Rgb lux_dome_radiance(const LightDesc& light) { return authored_radiance(light); }

bool lux_emits(const LightDesc& light) { return !is_black(authored_radiance(light)); }

bool lux_is_thin(const LightDesc& light) {
    if (light.kind == LightKind::Sphere) return light.radius == 0 || light.treat_as_point;
    return light.kind == LightKind::Cylinder && (light.radius == 0 || light.treat_as_line);
}

std::optional<TextureDesc> lux_texture(const LightDesc& light) {
    const bool dome = light.kind == LightKind::Dome;
    if ((!dome && light.kind != LightKind::Rect) || light.texture_file.empty() || !lux_emits(light)) return {};
    TextureDesc texture;
    texture.name = light.name;
    texture.file = light.texture_file;
    texture.color_space = light.texture_color_space;
    texture.wrap_s = dome ? TextureWrap::Repeat : TextureWrap::Clamp;
    texture.wrap_t = TextureWrap::Clamp;
    return texture;
}

Frame lux_dome_frame(const LightDesc& light, const Transform& world_from_light) {
    const bool z_up = light.pole_axis == Axis::Z;
    const Vec3 top = normalize(world_from_light.vector(z_up ? Vec3{0, 0, 1} : Vec3{0, 1, 0}));
    const Vec3 middle = world_from_light.vector(z_up ? Vec3{0, -1, 0} : Vec3{0, 0, 1});
    const Vec3 n = normalize(middle - top * dot(middle, top));
    const Vec3 left = cross(top, n);
    return {world_from_light.flips_handedness() ? -left : left, top, n};
}

Rgb lux_point_intensity(const LightDesc& light, double world_area) {
    if (light.normalize || world_area == 0) return authored_radiance(light) / 4;
    return authored_radiance(light) * (world_area / 4);
}

Rgb lux_line_intensity(const LightDesc& light, double world_area, double world_length) {
    if (light.normalize || world_area == 0) return authored_radiance(light) / (kPi * world_length);
    return authored_radiance(light) * (world_area / (kPi * world_length));
}

Rgb lux_shaping(const ShapingDesc& shaping, double theta) {
    const double angle = shaping.cone_angle * (kPi / 180);
    if (theta > angle) return {};
    double cone = 1;
    if (const double start = angle * (1 - std::clamp(shaping.cone_softness, 0.0, 1.0)); theta > start) {
        const double x = (theta - start) / (angle - start);
        cone = 1 - x * x * (3 - 2 * x);
    }
    if (!(shaping.focus > 0)) return Rgb(cone);
    const double f = std::pow(std::abs(std::cos(theta)), shaping.focus);
    const auto tinted = [f](double tint) { return f + (1 - f) * std::max(0.0, tint); };
    const Color& tint = shaping.focus_tint;
    return Rgb{tinted(tint[0]), tinted(tint[1]), tinted(tint[2])} * cone;
}

double lux_shaping_end(const ShapingDesc& shaping) { return std::clamp(shaping.cone_angle, 0.0, 180.0) * (kPi / 180); }

}  // namespace etendue
