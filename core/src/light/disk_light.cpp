#include "light/disk_light.h"

#include <cmath>

#include "light/point_error.h"
#include "math/sampling.h"

namespace etendue {

DiskLight::DiskLight(const Transform& world_from_light, double radius, const Rgb& radiance)
    : AreaLight(radiance, world_area(world_from_light, radius)),
      world_from_light_(world_from_light),
      n_(normalize(world_from_light.normal({0, 0, -1}))),
      radius_(radius) {}

double DiskLight::world_area(const Transform& world_from_light, double radius) {
    return kPi * length(cross(world_from_light.vector({radius, 0, 0}), world_from_light.vector({0, radius, 0})));
}

AreaLight::PointSample DiskLight::sample_point(const Vec2& u) const {
    const Vec2 d = sample_concentric_disk(u);
    const Vec3 p{d.x * radius_, d.y * radius_, 0};
    LightPoint y;
    y.p = world_from_light_.point(p);
    y.n = n_;
    y.p_error = float_point_error(world_from_light_.magnitude(p));
    return {y, 1 / area()};
}

double DiskLight::pdf_point(const LightPoint&) const { return 1 / area(); }

std::optional<LightBounds> DiskLight::bounds() const {
    const Vec3 x = world_from_light_.vector({radius_, 0, 0});
    const Vec3 y = world_from_light_.vector({0, radius_, 0});
    const Vec3 half{std::hypot(x.x, y.x), std::hypot(x.y, y.y), std::hypot(x.z, y.z)};
    const Vec3& center = world_from_light_.translation();
    return shaped_bounds({center - half, center + half, n_, 1});
}

}  // namespace etendue
