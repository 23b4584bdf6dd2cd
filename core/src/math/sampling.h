#pragma once

#include <algorithm>
#include <cmath>

#include "math/constants.h"
#include "math/vec.h"

namespace etendue {

/// Largest double below 1: keeps remapped random numbers inside [0, 1).
inline constexpr double kOneMinusEpsilon = 1 - 0x1p-53;

/// Concentric map of the unit square to the unit disk (Shirley and Chiu 1997); density 1/pi.
inline Vec2 sample_concentric_disk(const Vec2& u) {
    const double x = 2 * u.x - 1;
    const double y = 2 * u.y - 1;
    if (x == 0 && y == 0) return {0, 0};
    const bool wide = std::abs(x) > std::abs(y);
    const double r = wide ? x : y;
    const double phi = wide ? (kPi / 4) * (y / x) : kPi / 2 - (kPi / 4) * (x / y);
    return {r * std::cos(phi), r * std::sin(phi)};
}

/// Cosine-weighted direction about +z; density cos/pi per solid angle.
inline Vec3 sample_cosine_hemisphere(const Vec2& u) {
    const Vec2 d = sample_concentric_disk(u);
    return {d.x, d.y, std::sqrt(std::max(0.0, 1 - d.x * d.x - d.y * d.y))};
}

/// Uniform direction; density 1/(4 pi).
inline Vec3 sample_uniform_sphere(const Vec2& u) {
    const double z = 1 - 2 * u.x;
    const double r = 2 * std::sqrt(u.x * (1 - u.x));
    const double phi = 2 * kPi * u.y;
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// 1 - cos(theta) without cancellation, from sin^2(theta) for theta <= pi/2.
inline double one_minus_cos(double sin2) { return sin2 / (1 + std::sqrt(std::max(0.0, 1 - sin2))); }

/// Uniform direction in the cone of directions about +z with 1 - cos(theta) <= one_minus_cos_max; density
/// 1 / (2 pi one_minus_cos_max) per solid angle. Holds its digits for the narrowest cones.
inline Vec3 sample_uniform_cone(const Vec2& u, double one_minus_cos_max) {
    const double v = u.x * one_minus_cos_max;
    const double r = std::sqrt(std::max(0.0, v * (2 - v)));
    const double phi = 2 * kPi * u.y;
    return {r * std::cos(phi), r * std::sin(phi), 1 - v};
}

/// Uniform point in a triangle as the barycentric weights of its second and third corner.
inline Vec2 sample_uniform_triangle(const Vec2& u) {
    const double root = std::sqrt(u.x);
    return {root * (1 - u.y), root * u.y};
}

}  // namespace etendue
