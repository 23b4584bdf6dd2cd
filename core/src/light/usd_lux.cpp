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

std::optional<TextureDesc> lux_texture(const LightDesc& light) {
    if (light.kind != LightKind::Dome || light.texture_file.empty()) return {};
    TextureDesc texture;
    texture.name = light.name;
    texture.file = light.texture_file;
    texture.color_space = light.texture_color_space;
    texture.wrap_s = TextureWrap::Repeat;
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

}  // namespace etendue
