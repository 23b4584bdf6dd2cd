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

void PointLight::shape(const Shaping& shaping) {
    beam_ = std::make_unique<Beam>(shaping, shaping.axis(), [](const Vec3&) { return 1.0; });
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
    if (!beam_) return sample;
    sample.weight *= beam_->factor(-sample.wi);
    if (is_black(sample.weight)) return {};
    return sample;
}

EmissionSample PointLight::sample_emission(const Vec2&, const Vec2& u_dir) const {
    EmissionSample sample;
    sample.y = light_point();
    sample.origin = position_;
    sample.direction = beam_ ? beam_->sample(u_dir) : sample_uniform_sphere(u_dir);
    sample.pdf = pdf_emission(sample.y, sample.direction);
    if (!(sample.pdf.pdf_dir > 0)) return sample;  // a rounding has carried it over the beam's edge
    sample.weight = intensity_ / sample.pdf.pdf_dir;
    if (beam_) sample.weight *= beam_->factor(sample.direction);
    return sample;
}

EmissionPdf PointLight::pdf_emission(const LightPoint&, const Vec3& w) const {
    return {1, beam_ ? beam_->pdf(w) : kUniformPdf};
}

Rgb PointLight::power() const { return intensity_ * (beam_ ? beam_->integral() : Rgb(4 * kPi)); }

std::optional<LightBounds> PointLight::bounds() const {
    const LightBounds plain{position_, position_};
    return beam_ ? narrowed(plain, *beam_) : plain;
}

}  // namespace etendue
