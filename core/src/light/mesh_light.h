#pragma once

#include <array>
#include <memory>
#include <vector>

#include "light/area_light.h"
#include "light/emission_texture.h"
#include "math/distribution.h"

namespace etendue {

/// World space; the front is where the corners run counter-clockwise.
struct LightTriangle {
    std::array<Vec3, 3> p;
    std::array<Vec2, 3> st;
    Vec3 plane_error{};  ///< per axis, how far off Embree may take its plane (plane_roundings.h)
};

/// Triangles that emit from their front; points are uniform per area.
class MeshLight final : public AreaLight {
public:
    /// The triangles' area must be positive. `texture` may be null; else the radiance is multiplied by it.
    MeshLight(std::vector<LightTriangle> triangles, const Rgb& radiance,
              std::shared_ptr<const EmissionTexture> texture);

    [[nodiscard]] static double world_area(const std::vector<LightTriangle>& triangles);

    [[nodiscard]] std::optional<LightBounds> bounds() const override;
    [[nodiscard]] std::size_t memory_used() const override {
        return triangles_.capacity() * sizeof(LightTriangle) + by_area_.memory_used();
    }

protected:
    [[nodiscard]] PointSample sample_point(const Vec2& u) const override;
    [[nodiscard]] double pdf_point(const LightPoint&) const override { return 1 / area(); }
    [[nodiscard]] Rgb emitted(const LightPoint& y) const override;
    /// With a texture, an estimate from fixed points. Never zero unless the radiance is.
    [[nodiscard]] Rgb mean_emitted() const override { return mean_emitted_; }
    [[nodiscard]] Beam::Silhouette silhouette() const override;

private:
    [[nodiscard]] Rgb estimate_mean() const;

    std::vector<LightTriangle> triangles_;
    Distribution by_area_;
    std::shared_ptr<const EmissionTexture> texture_;
    Rgb mean_emitted_;
};

}  // namespace etendue
