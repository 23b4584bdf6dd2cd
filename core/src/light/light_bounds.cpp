#include "light/light_bounds.h"

#include <algorithm>
#include <cmath>

#include "math/constants.h"

namespace etendue {
namespace {

double angle_of(double cos) { return std::acos(std::clamp(cos, -1.0, 1.0)); }

/// `a`, turned by `angle` towards `b`.
Vec3 turned(const Vec3& a, const Vec3& b, double angle) {
    const Vec3 across = normalize(b - a * dot(a, b));
    return a * std::cos(angle) + across * std::sin(angle);
}

struct Cone {
    Vec3 axis;
    double cos = -1;
};

Cone enclose_cones(const Cone& a, const Cone& b) {
    const double half_a = angle_of(a.cos);
    const double half_b = angle_of(b.cos);
    const double between = angle_of(dot(a.axis, b.axis));
    if (between + half_b <= half_a) return a;
    if (between + half_a <= half_b) return b;
    const double half = (half_a + between + half_b) / 2;
    // Nothing says which way opposite axes turn.
    if (!(half < kPi) || length_squared(cross(a.axis, b.axis)) == 0) return {};
    return {normalize(turned(a.axis, b.axis, half - half_a)), std::cos(half)};
}

}  // namespace

double LightBounds::emission_measure() const {
    // 2 pi times the integral of sin t over the normals' cone and of sin t cos(t - normals) beyond it.
    const double normals = angle_of(cos_normals);
    const double end = std::min(normals + angle_of(cos_emission), kPi);
    const double beyond = 2 * (end - normals) * std::sin(normals) - std::cos(normals - 2 * end) + std::cos(normals);
    return 2 * kPi * (1 - std::cos(normals)) + kPi / 2 * beyond;
}

LightBounds enclose(const LightBounds& a, const LightBounds& b) {
    LightBounds sum;
    sum.lower = min(a.lower, b.lower);
    sum.upper = max(a.upper, b.upper);
    const Cone cone = enclose_cones({a.axis, a.cos_normals}, {b.axis, b.cos_normals});
    sum.cos_normals = cone.cos;
    if (cone.cos > -1) sum.axis = cone.axis;
    sum.cos_emission = std::min(a.cos_emission, b.cos_emission);
    return sum;
}

}  // namespace etendue
