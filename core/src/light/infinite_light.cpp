#include "light/infinite_light.h"

#include "math/frame.h"
#include "math/sampling.h"

namespace etendue {
namespace {

/// Rays start this many scene radii from the centre: outside, yet near enough for float origins to keep their digits.
constexpr double kStartDistance = 1.01;

LightPoint direction_point(const Vec3& to_light) {
    LightPoint y;
    y.p = to_light;
    y.n = -to_light;
    return y;
}

}  // namespace

InfiniteLight::InfiniteLight(const SceneBounds& bounds) : bounds_(bounds) {
    if (!(bounds_.radius > 0)) bounds_.radius = 1;  // an empty scene; any disk will do
}

double InfiniteLight::disk_area() const { return kPi * bounds_.radius * bounds_.radius; }

std::optional<DirectSample> InfiniteLight::sample_direct(const Vec3&, const Vec2& u) const {
    const DirectionSample direction = sample_direction(u);
    DirectSample sample;
    sample.y = direction_point(direction.to_light);
    sample.wi = direction.to_light;
    sample.distance = kInfinity;
    sample.weight = direction.weight;
    sample.pdf_point = direction.pdf;
    return sample;
}

double InfiniteLight::pdf_direct(const Vec3&, const LightPoint& y) const { return pdf_direction(y.p); }

EmissionSample InfiniteLight::sample_emission(const Vec2& u_point, const Vec2& u_dir) const {
    const DirectionSample direction = sample_direction(u_point);
    const Vec2 disk = sample_concentric_disk(u_dir);
    EmissionSample sample;
    sample.y = direction_point(direction.to_light);
    const Vec3 local{disk.x, disk.y, kStartDistance};
    sample.origin = bounds_.center + Frame::from_normal(direction.to_light).to_world(local) * bounds_.radius;
    sample.direction = -direction.to_light;
    sample.weight = direction.weight * disk_area();
    sample.pdf = {direction.pdf, 1 / disk_area()};
    return sample;
}

EmissionPdf InfiniteLight::pdf_emission(const LightPoint& y, const Vec3&) const {
    return {pdf_direction(y.p), 1 / disk_area()};
}

Rgb InfiniteLight::power() const { return fluence() * disk_area(); }

}  // namespace etendue
