#include "geometry/quadric.h"

#include <cmath>
#include <utility>

#include "math/constants.h"

namespace etendue {
namespace {

Vec3 across_x(const Vec3& v) { return {0, v.y, v.z}; }

/// Both roots, in order, of |o + t d|^2 = r^2; d must not be zero. The discriminant comes from the distance to the
/// centre of the chord and the roots from the form without cancellation, so that far and tiny spheres keep their
/// digits.
std::optional<std::pair<double, double>> sphere_roots(const Vec3& o, const Vec3& d, double radius) {
    const double a = length_squared(d);
    const double half_b = dot(o, d);
    const Vec3 to_chord = o - d * (half_b / a);
    const double slack = radius * radius - length_squared(to_chord);
    if (slack < 0) return {};
    const double root = std::sqrt(slack * a);
    const double q = half_b < 0 ? -half_b + root : -half_b - root;
    const double c = (length(o) - radius) * (length(o) + radius);
    double t0 = q / a;
    double t1 = q == 0 ? 0 : c / q;
    if (t0 > t1) std::swap(t0, t1);
    return std::pair{t0, t1};
}

}  // namespace

std::optional<double> Quadric::intersect(const Vec3& origin, const Vec3& direction, double t_near, double t_far) const {
    const Vec3 o = parent_from_object.inverse_point(origin);
    const Vec3 d = parent_from_object.inverse_vector(direction);
    const auto inside = [=](double t) { return t > t_near && t < t_far; };
    if (kind == QuadricKind::Disk) {
        if (d.z == 0) return {};
        const double t = -o.z / d.z;
        const double x = o.x + t * d.x;
        const double y = o.y + t * d.y;
        if (!inside(t) || x * x + y * y > radius * radius) return {};
        return t;
    }
    const bool tube = kind == QuadricKind::Tube;
    if (tube && d.y == 0 && d.z == 0) return {};
    const auto roots = tube ? sphere_roots(across_x(o), across_x(d), radius) : sphere_roots(o, d, radius);
    if (!roots) return {};
    for (const double t : {roots->first, roots->second}) {
        if (inside(t) && !(tube && std::abs(o.x + t * d.x) > half_length)) return t;
    }
    return {};
}

Vec3 Quadric::project(const Vec3& p) const {
    const Vec3 o = parent_from_object.inverse_point(p);
    switch (kind) {
        case QuadricKind::Disk:
            return parent_from_object.point({o.x, o.y, 0});
        case QuadricKind::Tube: {
            const double scale = radius / std::hypot(o.y, o.z);
            return parent_from_object.point({o.x, o.y * scale, o.z * scale});
        }
        case QuadricKind::Sphere:
            break;
    }
    return parent_from_object.point(o * (radius / length(o)));
}

Vec3 Quadric::normal(const Vec3& p) const {
    Vec3 n_object = parent_from_object.inverse_point(p);
    if (kind == QuadricKind::Disk) n_object = {0, 0, 1};
    if (kind == QuadricKind::Tube) n_object = across_x(n_object);
    const Vec3 n = normalize(parent_from_object.normal(n_object));
    return flipped ? -n : n;
}

Vec2 Quadric::st(const Vec3& p) const {
    const Vec3 o = parent_from_object.inverse_point(p);
    const bool tube = kind == QuadricKind::Tube;
    const double longitude = (tube ? std::atan2(o.z, o.y) : std::atan2(o.y, o.x)) / (2 * kPi);
    const double s = longitude < 0 ? longitude + 1 : longitude;
    if (tube) return {s, o.x / (2 * half_length) + 0.5};
    if (kind == QuadricKind::Disk) return {s, std::hypot(o.x, o.y) / radius};
    return {s, std::atan2(o.z, std::hypot(o.x, o.y)) / kPi + 0.5};
}

Vec3 Quadric::extent() const {
    return {kind == QuadricKind::Tube ? half_length : radius, radius, kind == QuadricKind::Disk ? 0 : radius};
}

Quadric::Bounds Quadric::bounds() const {
    // An ellipsoid reaches |row_i| r along axis i: half-widths are the row lengths, or of the first two columns.
    Vec3 half;
    const Vec3 size = extent();
    const Vec3 ex = parent_from_object.vector({size.x, 0, 0});
    const Vec3 ey = parent_from_object.vector({0, size.y, 0});
    const Vec3 ez = parent_from_object.vector({0, 0, size.z});
    if (kind == QuadricKind::Tube) {  // along its axis it reaches all the way
        half = abs(ex) + Vec3{std::hypot(ey.x, ez.x), std::hypot(ey.y, ez.y), std::hypot(ey.z, ez.z)};
    } else {
        half = {std::hypot(ex.x, ey.x, ez.x), std::hypot(ex.y, ey.y, ez.y), std::hypot(ex.z, ey.z, ez.z)};
    }
    const Vec3 center = parent_from_object.translation();
    return {center - half, center + half};
}

}  // namespace etendue
