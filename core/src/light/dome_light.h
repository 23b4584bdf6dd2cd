#pragma once

#include "light/infinite_light.h"
#include "math/sampling.h"

namespace etendue {

/// Constant radiance from every direction.
class DomeLight final : public InfiniteLight {
public:
    DomeLight(const SceneBounds& bounds, const Rgb& radiance) : InfiniteLight(bounds), radiance_(radiance) {}

    [[nodiscard]] Rgb radiance(const LightPoint&, const Vec3&) const override { return radiance_; }

protected:
    [[nodiscard]] DirectionSample sample_direction(const Vec2& u) const override {
        return {sample_uniform_sphere(u), radiance_ * (4 * kPi), kInvPi / 4};
    }
    [[nodiscard]] double pdf_direction(const Vec3&) const override { return kInvPi / 4; }
    [[nodiscard]] Rgb fluence() const override { return radiance_ * (4 * kPi); }

private:
    Rgb radiance_;
};

}  // namespace etendue
