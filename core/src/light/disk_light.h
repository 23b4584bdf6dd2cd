#pragma once

#include "light/area_light.h"
#include "math/transform.h"

namespace etendue {

/// A disk about the origin of the XY plane of light space (an ellipse in the world); emits along -Z.
class DiskLight final : public AreaLight {
public:
    DiskLight(const Transform& world_from_light, double radius, const Rgb& radiance);

    [[nodiscard]] static double world_area(const Transform& world_from_light, double radius);
    [[nodiscard]] std::optional<LightBounds> bounds() const override;

protected:
    [[nodiscard]] PointSample sample_point(const Vec2& u) const override;
    [[nodiscard]] double pdf_point(const LightPoint& y) const override;
    [[nodiscard]] Beam::Silhouette silhouette() const override {
        return [this](const Vec3& w) { return area() * std::max(0.0, dot(n_, w)); };
    }
    [[nodiscard]] Vec3 flat_normal() const override { return n_; }

private:
    Transform world_from_light_;
    Vec3 n_;
    double radius_;
};

}  // namespace etendue
