#include "light/emission_aim.h"

#include <algorithm>
#include <cmath>

#include "math/constants.h"
#include "math/frame.h"
#include "math/sampling.h"

namespace etendue {
namespace {

/// Of all subpaths, this share is aimed at most: what is lit without casters goes on being lit.
constexpr double kMostAimed = 0.5;
/// Targets get so many times their natural share at most: the tiniest of bodies must not draw half of all light.
constexpr double kMostBoost = 32;

}  // namespace

EmissionAim::EmissionAim(const std::vector<Sphere>& targets) : count_(std::min(targets.size(), kMostTargets)) {
    std::copy_n(targets.begin(), count_, spheres_.begin());
}

const EmissionAim::Target& EmissionAim::Aimed::choose(double& u) const {
    std::size_t i = 0;
    for (; i + 1 < count && u >= targets[i].share; ++i) u -= targets[i].share;
    u = std::clamp(u / targets[i].share, 0.0, kOneMinusEpsilon);
    return targets[i];
}

/// Turns shares of the light's own density into shares of the mixture; `caught` is their sum.
void EmissionAim::Aimed::settle(double caught) {
    if (!(caught > 0 && caught < 1)) {
        count = 0;
        return;
    }
    share = std::min(kMostAimed, kMostBoost * caught) * (1 - caught);
    for (std::size_t i = 0; i < count; ++i) targets[i].share *= share / caught;
}

EmissionAim::Aimed EmissionAim::aim_from_point(const Light& light, const LightPoint& y) const {
    Aimed aimed;
    double caught = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        const Sphere& sphere = spheres_[i];
        const Vec3 to_center = sphere.center - y.p;
        const double d2 = length_squared(to_center);
        const double r2 = sphere.radius * sphere.radius;
        if (d2 <= r2) continue;  // all directions meet what is around the light
        const Vec3 axis = to_center / std::sqrt(d2);
        const double versed = one_minus_cos(r2 / d2);
        const double solid_angle = 2 * kPi * versed;
        const double share = light.pdf_emission(y, axis).pdf_dir * solid_angle;
        if (!(share > 0)) continue;
        caught += share;
        aimed.targets[aimed.count++] = {axis, 2 * versed, 1 / solid_angle, share};  // |a - b|^2 = 2 (1 - cos)
    }
    aimed.settle(caught);
    return aimed;
}

EmissionAim::Aimed EmissionAim::aim_from_infinity(double own_pdf) const {
    Aimed aimed;
    double caught = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        const double r2 = spheres_[i].radius * spheres_[i].radius;
        const double area = kPi * r2;
        caught += area * own_pdf;
        aimed.targets[aimed.count++] = {spheres_[i].center, r2, 1 / area, area * own_pdf};
    }
    aimed.settle(caught);
    return aimed;
}

EmissionAim::Aimed EmissionAim::aim(const Light& light, const LightPoint& y, double own_pdf) const {
    return light.infinite() ? aim_from_infinity(own_pdf) : aim_from_point(light, y);
}

double EmissionAim::mixed_pdf(const Aimed& aimed, bool infinite, double own_pdf, const Vec3& w, const Vec3& x) {
    double pdf = (1 - aimed.share) * own_pdf;
    for (std::size_t i = 0; i < aimed.count; ++i) {
        const Target& target = aimed.targets[i];
        const Vec3 off = infinite ? cross(x - target.center, w) : w - target.center;
        if (length_squared(off) <= target.size2) pdf += target.share * target.density;
    }
    return pdf;
}

EmissionPdf EmissionAim::pdf(const Light& light, const LightPoint& y, const Vec3& w, const Vec3& x) const {
    EmissionPdf pdf = light.pdf_emission(y, w);
    if (count_ == 0) return pdf;
    pdf.pdf_dir = mixed_pdf(aim(light, y, pdf.pdf_dir), light.infinite(), pdf.pdf_dir, w, x);
    return pdf;
}

/// The light's own sample, turned to the target, or moved when it comes from infinity.
EmissionSample EmissionAim::sample_target(const Light& light, const EmissionSample& own, const Target& target,
                                          const Vec2& u) {
    EmissionSample sample = own;
    if (light.infinite()) {
        const Vec2 disk = sample_concentric_disk(u);
        const Vec3& to_light = own.y.p;
        const Vec3 across = Frame::from_normal(to_light).to_world({disk.x, disk.y, 0}) * std::sqrt(target.size2);
        const Vec3 origin = target.center + across;
        // As far out as the light's own rays begin.
        sample.origin = origin + to_light * dot(own.origin - origin, to_light);
        return sample;
    }
    sample.direction = Frame::from_normal(target.center).to_world(sample_uniform_cone(u, target.size2 / 2));
    sample.pdf.pdf_dir = light.pdf_emission(own.y, sample.direction).pdf_dir;
    const double pdf = own.pdf.pdf_point * sample.pdf.pdf_dir;
    sample.weight =
        pdf > 0 ? light.emission(own.y, sample.direction) / pdf : Rgb{};  // a cone may look behind the light
    return sample;
}

EmissionSample EmissionAim::sample(const Light& light, const Vec2& u_point, const Vec2& u_dir) const {
    EmissionSample sample = light.sample_emission(u_point, u_dir);
    if (count_ == 0) return sample;
    const Aimed aimed = aim(light, sample.y, sample.pdf.pdf_dir);
    if (aimed.share == 0) return sample;
    Vec2 u = u_dir;
    if (u.x < aimed.share) {
        const Target& target = aimed.choose(u.x);
        sample = sample_target(light, sample, target, u);
    } else {
        u.x = std::min((u.x - aimed.share) / (1 - aimed.share), kOneMinusEpsilon);
        sample = light.sample_emission(u_point, u);
    }
    const double own_pdf = sample.pdf.pdf_dir;
    sample.pdf.pdf_dir = mixed_pdf(aimed, light.infinite(), own_pdf, sample.direction, sample.origin);
    sample.weight *= sample.pdf.pdf_dir > 0 ? own_pdf / sample.pdf.pdf_dir : 0;  // was by its own density
    return sample;
}

}  // namespace etendue
