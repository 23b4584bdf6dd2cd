#include "light/area_light.h"

#include "math/constants.h"
#include "math/frame.h"
#include "math/measure.h"
#include "math/sampling.h"

namespace etendue {

void AreaLight::shape(const Shaping& shaping) {
    const Vec3 n = flat_normal();
    const bool flat = length_squared(n) > 0;
    beam_ = std::make_unique<Beam>(shaping, flat ? n : shaping.axis(), silhouette());
    // A flat light's beam holds the cosine. Of a round one half the points turn away from any direction: the mean
    // square of its weights, in units of their squared mean, is that of a cosine of points all around a sphere,
    // (1/6) / (1/4)^2, and by the cosine it is the concentration.
    emits_by_beam_ = flat || beam_->concentration() > 8 / 3.0;
}

Rgb AreaLight::emitted_along(const LightPoint& y, const Vec3& w) const {
    return beam_ ? emitted(y) * beam_->factor(w) : emitted(y);
}

Rgb AreaLight::radiance(const LightPoint& y, const Vec3& w) const {
    return dot(w, y.n) > 0 ? emitted_along(y, w) : Rgb{};
}

std::optional<DirectSample> AreaLight::direct_sample(const Vec3& receiver, const PointSample& point) const {
    if (!faces(point.y, receiver)) return {};
    const Vec3 to_light = point.y.p - receiver;
    DirectSample sample;
    sample.y = point.y;
    sample.distance = length(to_light);
    sample.wi = to_light / sample.distance;
    const Rgb radiance = emitted_along(point.y, -sample.wi);
    if (is_black(radiance)) return {};
    // L / pdf_w with pdf_w = pdf_a d^2 / |cos|.
    sample.weight = radiance * (area_per_solid_angle(receiver, point.y.p, point.y.n) / point.pdf);
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
    EmissionSample sample;
    sample.y = point.y;
    sample.origin = point.y.p;
    const bool diffuse = !emits_by_beam_;
    const Vec3 local = diffuse ? sample_cosine_hemisphere(u_dir) : Vec3{};
    sample.direction = diffuse ? Frame::from_normal(point.y.n).to_world(local) : beam_->sample(u_dir);
    const double cos = diffuse ? local.z : dot(sample.direction, point.y.n);
    sample.pdf = {point.pdf, diffuse ? local.z * kInvPi : beam_->pdf(sample.direction)};
    // From the back nothing leaves, nor where a rounding has carried the direction over the beam's edge.
    if (!diffuse && !(cos > 0 && sample.pdf.pdf_dir > 0)) return sample;
    const double per_direction = diffuse ? kPi : cos / sample.pdf.pdf_dir;
    sample.weight = emitted_along(point.y, sample.direction) * (per_direction / point.pdf);
    return sample;
}

double AreaLight::pdf_emission_direction(const Vec3& n, const Vec3& w) const {
    const double cos = dot(w, n);
    if (!(cos > 0)) return 0;
    return emits_by_beam_ ? beam_->pdf(w) : cos * kInvPi;
}

EmissionPdf AreaLight::pdf_emission(const LightPoint& y, const Vec3& w) const {
    return {pdf_point(y), pdf_emission_direction(y.n, w)};
}

Rgb AreaLight::power() const { return mean_emitted() * (beam_ ? beam_->integral() : Rgb(kPi * area_)); }

LightBounds AreaLight::shaped_bounds(LightBounds bounds) const { return beam_ ? narrowed(bounds, *beam_) : bounds; }

}  // namespace etendue
