#include "light/area_light.h"

#include "math/constants.h"
#include "math/frame.h"
#include "math/measure.h"
#include "math/sampling.h"

namespace etendue {

Rgb AreaLight::radiance(const LightPoint& y, const Vec3& w) const { return dot(w, y.n) > 0 ? emitted(y) : Rgb{}; }

std::optional<DirectSample> AreaLight::direct_sample(const Vec3& receiver, const PointSample& point) const {
    if (!faces(point.y, receiver)) return {};
    const Vec3 to_light = point.y.p - receiver;
    DirectSample sample;
    sample.y = point.y;
    sample.distance = length(to_light);
    sample.wi = to_light / sample.distance;
    // L / pdf_w with pdf_w = pdf_a d^2 / |cos|.
    sample.weight = emitted(point.y) * (area_per_solid_angle(receiver, point.y.p, point.y.n) / point.pdf);
    sample.pdf_point = point.pdf;
    return sample;
}

std::optional<DirectSample> AreaLight::sample_direct(const Vec3& receiver, const Vec2& u) const {
    return direct_sample(receiver, sample_point(u));
}

double AreaLight::pdf_direct(const Vec3& receiver, const LightPoint& y) const {
    return faces(y, receiver) ? pdf_point(y) : 0;
}

EmissionSample AreaLight::sample_emission(const Vec2& u_point, const Vec2& u_dir) const {
    const PointSample point = sample_point(u_point);
    const Vec3 local = sample_cosine_hemisphere(u_dir);
    EmissionSample sample;
    sample.y = point.y;
    sample.origin = point.y.p;
    sample.direction = Frame::from_normal(point.y.n).to_world(local);
    sample.pdf = {point.pdf, local.z * kInvPi};
    sample.weight = emitted(point.y) * (kPi / point.pdf);  // the cosine cancels
    return sample;
}

EmissionPdf AreaLight::pdf_emission(const LightPoint& y, const Vec3& w) const {
    return {pdf_point(y), std::max(0.0, dot(w, y.n)) * kInvPi};
}

Rgb AreaLight::power() const { return radiance_ * (kPi * area_); }

}  // namespace etendue
