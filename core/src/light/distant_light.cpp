#include "light/distant_light.h"

#include <cmath>

#include "math/sampling.h"

namespace etendue {

DistantLight::DistantLight(const SceneBounds& bounds, const Vec3& to_light, double half_angle, const Rgb& radiance)
    : InfiniteLight(bounds), frame_(Frame::from_normal(to_light)), radiance_(radiance) {
    const double s = std::sin(half_angle / 2);
    one_minus_cos_ = 2 * s * s;  // keeps its digits for the narrowest cones
}

bool DistantLight::contains(const Vec3& to_light) const {
    return length_squared(to_light - frame_.n) <= 2 * one_minus_cos_;  // |a - b|^2 = 2 (1 - cos)
}

double DistantLight::solid_angle() const { return 2 * kPi * one_minus_cos_; }

Rgb DistantLight::radiance(const LightPoint& y, const Vec3&) const { return contains(y.p) ? radiance_ : Rgb{}; }

InfiniteLight::DirectionSample DistantLight::sample_direction(const Vec2& u) const {
    const Vec3 to_light = frame_.to_world(sample_uniform_cone(u, one_minus_cos_));
    return {to_light, radiance_ * solid_angle(), 1 / solid_angle()};
}

double DistantLight::pdf_direction(const Vec3& to_light) const { return contains(to_light) ? 1 / solid_angle() : 0; }

Rgb DistantLight::fluence() const { return radiance_ * solid_angle(); }

}  // namespace etendue
