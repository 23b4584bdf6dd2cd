#pragma once

#include "light/area_light.h"
#include "math/transform.h"

namespace etendue {

/// A sphere about the origin of light space (an ellipsoid in the world); emits outward. A receiver samples the cone of
/// directions that the sphere fills, in light space: uniform per solid angle when the transform is a similarity, and
/// from afar under any transform, for which the exact density follows from the Jacobian of the surface.
class SphereLight final : public AreaLight {
public:
    SphereLight(const Transform& world_from_light, double radius, const Rgb& radiance);

    [[nodiscard]] static double world_area(const Transform& world_from_light, double radius);

    [[nodiscard]] std::optional<DirectSample> sample_direct(const Vec3& receiver, const Vec2& u) const override;
    [[nodiscard]] double pdf_direct(const Vec3& receiver, const LightPoint& y) const override;
    [[nodiscard]] std::optional<LightBounds> bounds() const override;

protected:
    [[nodiscard]] PointSample sample_point(const Vec2& u) const override;
    [[nodiscard]] double pdf_point(const LightPoint& y) const override;
    [[nodiscard]] Beam::Silhouette silhouette() const override;

private:
    /// The receiver as the unit sphere sees it.
    struct View;
    [[nodiscard]] View view_from(const Vec3& receiver) const;

    /// World area per area of the unit sphere at the unit vector n.
    [[nodiscard]] double area_scale(const Vec3& n) const;
    [[nodiscard]] LightPoint light_point(const Vec3& n) const;
    [[nodiscard]] Vec3 unit_sphere_point(const LightPoint& y) const;

    Transform world_from_unit_;
};

}  // namespace etendue
