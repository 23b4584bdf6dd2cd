#include "light/rect_light.h"

#include "light/point_error.h"

namespace etendue {

RectLight::RectLight(const Transform& world_from_light, double width, double height, const Rgb& radiance)
    : AreaLight(radiance, world_area(world_from_light, width, height)),
      world_from_light_(world_from_light),
      n_(normalize(world_from_light.normal({0, 0, -1}))),
      width_(width),
      height_(height) {}

double RectLight::world_area(const Transform& world_from_light, double width, double height) {
    return length(cross(world_from_light.vector({width, 0, 0}), world_from_light.vector({0, height, 0})));
}

AreaLight::PointSample RectLight::sample_point(const Vec2& u) const {
    const Vec3 p{(u.x - 0.5) * width_, (u.y - 0.5) * height_, 0};
    LightPoint y;
    y.p = world_from_light_.point(p);
    y.n = n_;
    y.p_error = flat_point_error(world_from_light_.magnitude(p),
                                 max_component(world_from_light_.vector_magnitude({width_, height_, 0})));
    return {y, 1 / area()};
}

double RectLight::pdf_point(const LightPoint&) const { return 1 / area(); }

std::optional<LightBounds> RectLight::bounds() const {
    const Vec3 half =
        abs(world_from_light_.vector({width_ / 2, 0, 0})) + abs(world_from_light_.vector({0, height_ / 2, 0}));
    const Vec3& center = world_from_light_.translation();
    return LightBounds{center - half, center + half, n_, 1};
}

}  // namespace etendue
