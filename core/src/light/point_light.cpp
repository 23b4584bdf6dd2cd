#include "light/point_light.h"

#include "light/point_error.h"
#include "math/sampling.h"

namespace etendue {
namespace {

constexpr double kUniformPdf = kInvPi / 4;

}  // namespace

LightPoint PointLight::light_point() const {
    LightPoint y;
    y.p = position_;
    y.p_error = float_point_error(abs(position_));
    return y;
}

std::optional<DirectSample> PointLight::sample_direct(const Vec3& receiver, const Vec2&) const {
    const Vec3 to_light = position_ - receiver;
    const double distance = length(to_light);
    if (distance == 0) return {};
    DirectSample sample;
    sample.y = light_point();
    sample.distance = distance;
    sample.wi = to_light / distance;
    sample.weight = intensity_ / (distance * distance);
    sample.pdf_point = 1;
    return sample;
}

EmissionSample PointLight::sample_emission(const Vec2&, const Vec2& u_dir) const {
    EmissionSample sample;
    sample.y = light_point();
    sample.origin = position_;
    sample.direction = sample_uniform_sphere(u_dir);
    sample.weight = intensity_ / kUniformPdf;
    sample.pdf = {1, kUniformPdf};
    return sample;
}

EmissionPdf PointLight::pdf_emission(const LightPoint&, const Vec3&) const { return {1, kUniformPdf}; }

Rgb PointLight::power() const { return intensity_ * (4 * kPi); }

}  // namespace etendue
