#pragma once

#include "light/area_light.h"
#include "math/transform.h"

namespace etendue {

/// width x height in the XY plane of light space, centred; emits along -Z.
class RectLight final : public AreaLight {
public:
    RectLight(const Transform& world_from_light, double width, double height, const Rgb& radiance);

    [[nodiscard]] static double world_area(const Transform& world_from_light, double width, double height);
    [[nodiscard]] std::optional<LightBounds> bounds() const override;

protected:
    [[nodiscard]] PointSample sample_point(const Vec2& u) const override;
    [[nodiscard]] double pdf_point(const LightPoint& y) const override;

private:
    Transform world_from_light_;
    Vec3 n_;
    double width_;
    double height_;
};

}  // namespace etendue
