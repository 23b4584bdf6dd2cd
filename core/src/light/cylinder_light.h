#pragma once

#include "light/area_light.h"
#include "math/transform.h"

namespace etendue {

/// A tube about the x axis of light space without its ends, under any affine transform; emits outward. A receiver
/// samples the part of the surface that faces it.
class CylinderLight final : public AreaLight {
public:
    CylinderLight(const Transform& world_from_light, double length, double radius, const Rgb& radiance);

    /// Exact, whatever the transform makes of the circle.
    [[nodiscard]] static double world_area(const Transform& world_from_light, double length, double radius);

    [[nodiscard]] std::optional<DirectSample> sample_direct(const Vec3& receiver, const Vec2& u) const override;
    [[nodiscard]] double pdf_direct(const Vec3& receiver, const LightPoint& y) const override;
    [[nodiscard]] std::optional<LightBounds> bounds() const override;

protected:
    [[nodiscard]] PointSample sample_point(const Vec2& u) const override;
    [[nodiscard]] double pdf_point(const LightPoint& y) const override;
    [[nodiscard]] Beam::Silhouette silhouette() const override;

private:
    /// The arc of the unit tube, -1 <= x <= 1 and y^2 + z^2 = 1, that a receiver sees.
    struct Arc;
    [[nodiscard]] std::optional<Arc> seen_arc(const Vec3& receiver) const;

    /// World area per dx dphi of the unit tube at its normal n.
    [[nodiscard]] double area_scale(const Vec3& n) const;
    /// Of the unit tube, unit and perpendicular to x.
    [[nodiscard]] Vec3 unit_normal(const LightPoint& y) const;
    [[nodiscard]] LightPoint light_point(double x, const Vec3& n) const;

    Transform world_from_unit_;
};

}  // namespace etendue
