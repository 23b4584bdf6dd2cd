#include "light/line_light.h"

#include <cmath>

#include "light/point_error.h"
#include "math/sampling.h"

namespace etendue {

LineLight::LineLight(const Vec3& start, const Vec3& segment, const Rgb& lineic_radiance)
    : start_(start),
      segment_(segment),
      length_(length(segment)),
      frame_(Frame::from_normal(segment / length_)),
      lineic_radiance_(lineic_radiance) {}

LightPoint LineLight::light_point(double t) const {
    LightPoint y;
    y.p = start_ + segment_ * t;
    y.p_error = float_point_error(abs(start_) + abs(segment_));
    return y;
}

std::optional<DirectSample> LineLight::sample_direct(const Vec3& receiver, const Vec2& u) const {
    DirectSample sample;
    sample.y = light_point(u.x);
    const Vec3 to_light = sample.y.p - receiver;
    sample.distance = length(to_light);
    if (sample.distance == 0) return {};
    sample.wi = to_light / sample.distance;
    sample.weight = lineic_radiance_ * (sin_to_axis(sample.wi) * length_ / (sample.distance * sample.distance));
    if (beam_) sample.weight *= beam_->factor(-sample.wi);
    if (is_black(sample.weight)) return {};
    sample.pdf_point = 1 / length_;
    return sample;
}

Rgb LineLight::emission(const LightPoint&, const Vec3& w) const {
    const Rgb intensity = lineic_radiance_ * sin_to_axis(w);
    return beam_ ? intensity * beam_->factor(w) : intensity;
}

void LineLight::shape(const Shaping& shaping) {
    beam_ = std::make_unique<Beam>(shaping, shaping.axis(), [this](const Vec3& w) { return sin_to_axis(w); });
}

Vec3 LineLight::thin_tube_direction(double u_normal, const Vec2& u_dir) const {
    const double phi = 2 * kPi * u_normal;
    const Frame about_normal = Frame::from_normal(frame_.to_world({std::cos(phi), std::sin(phi), 0}));
    return about_normal.to_world(sample_cosine_hemisphere(u_dir));
}

EmissionSample LineLight::sample_emission(const Vec2& u_point, const Vec2& u_dir) const {
    EmissionSample sample;
    sample.y = light_point(u_point.x);
    sample.origin = sample.y.p;
    sample.direction = beam_ ? beam_->sample(u_dir) : thin_tube_direction(u_point.y, u_dir);
    sample.pdf = pdf_emission(sample.y, sample.direction);
    if (!beam_) {
        sample.weight = lineic_radiance_ * (kPi * kPi * length_);  // the sine cancels
        return sample;
    }
    if (!(sample.pdf.pdf_dir > 0)) return sample;  // a rounding has carried it over the beam's edge
    sample.weight = lineic_radiance_ * beam_->factor(sample.direction) *
                    (sin_to_axis(sample.direction) * length_ / sample.pdf.pdf_dir);
    return sample;
}

EmissionPdf LineLight::pdf_emission(const LightPoint&, const Vec3& w) const {
    return {1 / length_, beam_ ? beam_->pdf(w) : sin_to_axis(w) * (kInvPi * kInvPi)};
}

Rgb LineLight::power() const { return lineic_radiance_ * length_ * (beam_ ? beam_->integral() : Rgb(kPi * kPi)); }

std::optional<LightBounds> LineLight::bounds() const {
    const Vec3 end = start_ + segment_;
    const LightBounds plain{min(start_, end), max(start_, end)};
    return beam_ ? narrowed(plain, *beam_) : plain;
}

}  // namespace etendue
