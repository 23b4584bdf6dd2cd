#include "light/rect_light.h"

#include <utility>

#include "light/point_error.h"

namespace etendue {

RectLight::RectLight(const Transform& world_from_light, double width, double height, const Rgb& radiance,
                     std::optional<RectImage> image)
    : AreaLight(radiance, world_area(world_from_light, width, height)),
      world_from_light_(world_from_light),
      n_(normalize(world_from_light.normal({0, 0, -1}))),
      width_(width),
      height_(height),
      image_(std::move(image)) {}

double RectLight::world_area(const Transform& world_from_light, double width, double height) {
    return length(cross(world_from_light.vector({width, 0, 0}), world_from_light.vector({0, height, 0})));
}

double RectLight::pdf_in(const EmissionTable::Cell& cell) const {
    return cell.pmf / ((cell.x1 - cell.x0) * (cell.y1 - cell.y0) * area());
}

AreaLight::PointSample RectLight::sample_point(const Vec2& u) const {
    PointSample sample{{}, 1 / area()};
    Vec2 at = u;  // from the image's upper left corner
    if (image_) {
        const auto [cell, v] = image_->table.sample(u);
        at = {cell.x0 + (cell.x1 - cell.x0) * v.x, cell.y0 + (cell.y1 - cell.y0) * v.y};
        sample.pdf = pdf_in(cell);
    }
    const Vec3 p{(0.5 - at.x) * width_, (0.5 - at.y) * height_, 0};
    sample.y.p = world_from_light_.point(p);
    sample.y.n = n_;
    sample.y.st = {at.x, 1 - at.y};
    sample.y.p_error = flat_point_error(world_from_light_.magnitude(p),
                                        max_component(world_from_light_.vector_magnitude({width_, height_, 0})));
    return sample;
}

double RectLight::pdf_point(const LightPoint& y) const {
    return image_ ? pdf_in(image_->table.cell_at(y.st.x, 1 - y.st.y)) : 1 / area();
}

Rgb RectLight::emitted(const LightPoint& y) const {
    return image_ ? base_radiance() * image_->image->at(y.st) : base_radiance();
}

Rgb RectLight::mean_emitted() const { return image_ ? base_radiance() * image_->table.integral() : base_radiance(); }

std::optional<LightBounds> RectLight::bounds() const {
    const Vec3 half =
        abs(world_from_light_.vector({width_ / 2, 0, 0})) + abs(world_from_light_.vector({0, height_ / 2, 0}));
    const Vec3& center = world_from_light_.translation();
    return shaped_bounds({center - half, center + half, n_, 1});
}

}  // namespace etendue
