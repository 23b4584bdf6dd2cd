#include "light/sphere_light.h"

#include <cmath>

#include "light/ellipsoid_area.h"
#include "light/point_error.h"
#include "math/frame.h"
#include "math/measure.h"
#include "math/sampling.h"

namespace etendue {
namespace {

Transform world_from_unit_sphere(const Transform& world_from_light, double radius) {
    Matrix4 scale;
    scale.m[0] = scale.m[5] = scale.m[10] = radius;
    return world_from_light * Transform(scale);
}

}  // namespace

struct SphereLight::View {
    Vec3 p;                    ///< receiver
    double distance2 = 0;      ///< to the centre, squared
    double one_minus_cos = 0;  ///< of the cone that the sphere fills

    [[nodiscard]] bool outside() const { return distance2 > 1; }
    [[nodiscard]] double pdf_w() const { return 1 / (2 * kPi * one_minus_cos); }
};

SphereLight::SphereLight(const Transform& world_from_light, double radius, const Rgb& radiance)
    : AreaLight(radiance, world_area(world_from_light, radius)),
      world_from_unit_(world_from_unit_sphere(world_from_light, radius)) {}

double SphereLight::world_area(const Transform& world_from_light, double radius) {
    return ellipsoid_area(world_from_light) * (radius * radius);
}

double SphereLight::area_scale(const Vec3& n) const {
    return std::abs(world_from_unit_.determinant()) * length(world_from_unit_.normal(n));
}

LightPoint SphereLight::light_point(const Vec3& n) const {
    LightPoint y;
    y.p = world_from_unit_.point(n);
    y.n = normalize(world_from_unit_.normal(n));
    y.p_error = float_point_error(world_from_unit_.magnitude(n));
    return y;
}

Vec3 SphereLight::unit_sphere_point(const LightPoint& y) const {
    // From the normal, not the position: the normal keeps its digits when the sphere is small and far from the origin.
    return normalize(world_from_unit_.inverse_normal(y.n));
}

SphereLight::View SphereLight::view_from(const Vec3& receiver) const {
    const Vec3 p = world_from_unit_.inverse_point(receiver);
    const double distance2 = length_squared(p);
    return {p, distance2, distance2 > 1 ? one_minus_cos(1 / distance2) : 0};
}

std::optional<DirectSample> SphereLight::sample_direct(const Vec3& receiver, const Vec2& u) const {
    const View view = view_from(receiver);
    if (!view.outside()) return {};  // all of the surface shows its back
    const double d = std::sqrt(view.distance2);
    const Vec3 w = sample_uniform_cone(u, view.one_minus_cos);
    // The nearer crossing of the ray at angle theta to the axis a = -p/d lies at t = d cos - h, h^2 = 1 - d^2 sin^2;
    // written with sin^2 max - sin^2 = (V - v)(2 - V - v), V and v the versed sines, nothing cancels.
    const double v_max = view.one_minus_cos;
    const double v = u.x * v_max;
    const double h = d * std::sqrt((1 - u.x) * v_max * (2 - v_max - v));
    const double t = d * w.z - h;
    const double sin2 = w.x * w.x + w.y * w.y;
    // Relative to the centre, t w - d a = -(d sin^2 + h cos) a + t sin e.
    const Frame frame = Frame::from_normal(view.p / -d);
    const Vec3 n = normalize(frame.to_world({t * w.x, t * w.y, -(d * sin2 + h * w.z)}));

    const double pdf_unit_area = view.pdf_w() * area_per_solid_angle(view.p, n, n);
    return direct_sample(receiver, {light_point(n), pdf_unit_area / area_scale(n)});
}

double SphereLight::pdf_direct(const Vec3& receiver, const LightPoint& y) const {
    const View view = view_from(receiver);
    if (!view.outside() || !faces(y, receiver)) return 0;
    const Vec3 n = unit_sphere_point(y);
    return view.pdf_w() * area_per_solid_angle(view.p, n, n) / area_scale(n);
}

AreaLight::PointSample SphereLight::sample_point(const Vec2& u) const {
    const Vec3 n = sample_uniform_sphere(u);
    return {light_point(n), 1 / (4 * kPi * area_scale(n))};
}

double SphereLight::pdf_point(const LightPoint& y) const { return 1 / (4 * kPi * area_scale(unit_sphere_point(y))); }

Beam::Silhouette SphereLight::silhouette() const {
    return [this](const Vec3& w) {
        return kPi * std::abs(world_from_unit_.determinant()) * length(world_from_unit_.inverse_vector(w));
    };
}

std::optional<LightBounds> SphereLight::bounds() const {
    const Vec3 x = world_from_unit_.vector({1, 0, 0});
    const Vec3 y = world_from_unit_.vector({0, 1, 0});
    const Vec3 z = world_from_unit_.vector({0, 0, 1});
    const Vec3 half{std::hypot(x.x, y.x, z.x), std::hypot(x.y, y.y, z.y), std::hypot(x.z, y.z, z.z)};
    const Vec3& center = world_from_unit_.translation();
    return shaped_bounds({center - half, center + half});
}

}  // namespace etendue
