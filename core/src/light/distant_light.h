#pragma once

#include "light/infinite_light.h"
#include "math/frame.h"

namespace etendue {

/// Constant radiance over a cone of directions, up to the whole sphere.
class DistantLight final : public InfiniteLight {
public:
    /// `to_light` is the cone's axis, unit; half_angle in (0, pi], radians.
    DistantLight(const SceneBounds& bounds, const Vec3& to_light, double half_angle, const Rgb& radiance);

    [[nodiscard]] Rgb radiance(const LightPoint& y, const Vec3& w) const override;

protected:
    [[nodiscard]] DirectionSample sample_direction(const Vec2& u) const override;
    [[nodiscard]] double pdf_direction(const Vec3& to_light) const override;
    [[nodiscard]] Rgb fluence() const override;

private:
    [[nodiscard]] bool contains(const Vec3& to_light) const;
    [[nodiscard]] double solid_angle() const;

    Frame frame_;  ///< about the axis
    double one_minus_cos_;
    Rgb radiance_;
};

/// Light from a single direction: a distant light of angle 0.
class DeltaDistantLight final : public InfiniteLight {
public:
    /// Irradiance is that of a facing surface, lux.
    DeltaDistantLight(const SceneBounds& bounds, const Vec3& to_light, const Rgb& irradiance)
        : InfiniteLight(bounds), to_light_(to_light), irradiance_(irradiance) {}

    [[nodiscard]] Rgb radiance(const LightPoint&, const Vec3&) const override { return {}; }
    [[nodiscard]] bool delta() const override { return true; }

protected:
    [[nodiscard]] DirectionSample sample_direction(const Vec2&) const override { return {to_light_, irradiance_, 1}; }
    [[nodiscard]] double pdf_direction(const Vec3&) const override { return 1; }
    [[nodiscard]] Rgb fluence() const override { return irradiance_; }

private:
    Vec3 to_light_;
    Rgb irradiance_;
};

}  // namespace etendue
