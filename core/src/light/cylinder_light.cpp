#include "light/cylinder_light.h"

#include <cmath>

#include "light/ellipse.h"
#include "light/point_error.h"
#include "math/sampling.h"

namespace etendue {
namespace {

Transform world_from_unit_tube(const Transform& world_from_light, double length, double radius) {
    Matrix4 scale;
    scale.m[0] = length / 2;
    scale.m[5] = scale.m[10] = radius;
    return world_from_light * Transform(scale);
}

}  // namespace

struct CylinderLight::Arc {
    double middle;      ///< angle about x, from y to z
    double half_width;  ///< radians
};

CylinderLight::CylinderLight(const Transform& world_from_light, double length, double radius, const Rgb& radiance)
    : AreaLight(radiance, world_area(world_from_light, length, radius)),
      world_from_unit_(world_from_unit_tube(world_from_light, length, radius)) {}

double CylinderLight::world_area(const Transform& world_from_light, double length, double radius) {
    // dA = |p_x cross p_phi| dx dphi, which runs along an ellipse of its own as phi does.
    const Vec3 x = world_from_light.vector({length, 0, 0});
    return ellipse_perimeter(cross(x, world_from_light.vector({0, radius, 0})),
                             cross(x, world_from_light.vector({0, 0, radius})));
}

double CylinderLight::area_scale(const Vec3& n) const {
    return std::abs(world_from_unit_.determinant()) * length(world_from_unit_.normal(n));
}

Vec3 CylinderLight::unit_normal(const LightPoint& y) const {
    // From the normal, not the position: it keeps its digits when the tube is thin and far from the origin.
    const Vec3 n = world_from_unit_.inverse_normal(y.n);
    return normalize(Vec3{0, n.y, n.z});
}

LightPoint CylinderLight::light_point(double x, const Vec3& n) const {
    const Vec3 p{x, n.y, n.z};
    LightPoint y;
    y.p = world_from_unit_.point(p);
    y.n = normalize(world_from_unit_.normal(n));
    y.p_error = float_point_error(world_from_unit_.magnitude(p));
    return y;
}

std::optional<CylinderLight::Arc> CylinderLight::seen_arc(const Vec3& receiver) const {
    // A tangent plane has the receiver in front when n . p > 1.
    const Vec3 p = world_from_unit_.inverse_point(receiver);
    const double distance2 = p.y * p.y + p.z * p.z;
    if (!(distance2 > 1)) return {};
    return Arc{std::atan2(p.z, p.y), std::atan(std::sqrt(distance2 - 1))};
}

std::optional<DirectSample> CylinderLight::sample_direct(const Vec3& receiver, const Vec2& u) const {
    const auto arc = seen_arc(receiver);
    if (!arc) return {};
    const double phi = arc->middle + (2 * u.y - 1) * arc->half_width;
    const Vec3 n{0, std::cos(phi), std::sin(phi)};
    return direct_sample(receiver, {light_point(2 * u.x - 1, n), 1 / (4 * arc->half_width * area_scale(n))});
}

double CylinderLight::pdf_direct(const Vec3& receiver, const LightPoint& y) const {
    const auto arc = seen_arc(receiver);
    if (!arc || !faces(y, receiver)) return 0;
    return 1 / (4 * arc->half_width * area_scale(unit_normal(y)));
}

AreaLight::PointSample CylinderLight::sample_point(const Vec2& u) const {
    const double phi = 2 * kPi * u.y;
    const Vec3 n{0, std::cos(phi), std::sin(phi)};
    return {light_point(2 * u.x - 1, n), 1 / (4 * kPi * area_scale(n))};
}

double CylinderLight::pdf_point(const LightPoint& y) const { return 1 / (4 * kPi * area_scale(unit_normal(y))); }

Beam::Silhouette CylinderLight::silhouette() const {
    return [this](const Vec3& w) {
        const Vec3 v = world_from_unit_.inverse_vector(w);
        return 4 * std::abs(world_from_unit_.determinant()) * std::hypot(v.y, v.z);
    };
}

std::optional<LightBounds> CylinderLight::bounds() const {
    const Vec3 y = world_from_unit_.vector({0, 1, 0});
    const Vec3 z = world_from_unit_.vector({0, 0, 1});
    const Vec3 half = abs(world_from_unit_.vector({1, 0, 0})) +
                      Vec3{std::hypot(y.x, z.x), std::hypot(y.y, z.y), std::hypot(y.z, z.z)};
    const Vec3& center = world_from_unit_.translation();
    return shaped_bounds({center - half, center + half});
}

}  // namespace etendue
