#include "light/latlong_dome_light.h"

#include <cmath>
#include <utility>

#include "math/constants.h"

namespace etendue {
namespace {

/// 1 - cos of the angle from the top, which keeps its digits next to it.
double one_minus_cos_at(double y) {
    const double s = std::sin(y * (kPi / 2));
    return 2 * s * s;
}

double solid_angle(const EmissionTable::Cell& cell) {
    const double height = 2 * std::sin((cell.y0 + cell.y1) * (kPi / 2)) * std::sin((cell.y1 - cell.y0) * (kPi / 2));
    return 2 * kPi * (cell.x1 - cell.x0) * height;
}

}  // namespace

LatlongDomeLight::LatlongDomeLight(const SceneBounds& bounds, const Frame& dome, const Rgb& radiance,
                                   std::shared_ptr<const EmissionImage> image)
    : InfiniteLight(bounds),
      dome_(dome),
      radiance_(radiance),
      image_(std::move(image)),
      table_(*image_, latlong_rows(image_->height()), true) {}

Vec2 LatlongDomeLight::image_point(const Vec3& to_light) const {
    const Vec3 local = dome_.to_local(to_light);
    const double longitude = std::atan2(local.x, local.z);
    const double from_top = std::atan2(std::hypot(local.x, local.z), local.y);
    return {0.5 - longitude / (2 * kPi), from_top / kPi};
}

Rgb LatlongDomeLight::radiance(const LightPoint& y, const Vec3&) const {
    const Vec2 point = image_point(y.p);
    return radiance_ * image_->at({point.x, 1 - point.y});
}

InfiniteLight::DirectionSample LatlongDomeLight::sample_direction(const Vec2& u) const {
    const EmissionTable::Sample sample = table_.sample(u);
    const EmissionTable::Cell& cell = sample.cell;
    const double x = cell.x0 + (cell.x1 - cell.x0) * sample.u.x;
    const double longitude = (0.5 - x) * 2 * kPi;
    // Uniform in solid angle within the cell: no pole is special.
    const double top = one_minus_cos_at(cell.y0);
    const double v = top + (one_minus_cos_at(cell.y1) - top) * sample.u.y;
    const double sin = std::sqrt(std::max(0.0, v * (2 - v)));
    DirectionSample direction;
    direction.to_light = dome_.to_world({sin * std::sin(longitude), 1 - v, sin * std::cos(longitude)});
    direction.pdf = cell.pmf / solid_angle(cell);
    const Vec2 point = image_point(direction.to_light);
    direction.weight = radiance_ * image_->at({point.x, 1 - point.y}) / direction.pdf;
    return direction;
}

double LatlongDomeLight::pdf_direction(const Vec3& to_light) const {
    const Vec2 point = image_point(to_light);
    const EmissionTable::Cell cell = table_.cell_at(point.x, point.y);
    return cell.pmf / solid_angle(cell);
}

}  // namespace etendue
