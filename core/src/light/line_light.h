#pragma once

#include <memory>

#include "light/beam.h"
#include "light/light.h"
#include "math/frame.h"

namespace etendue {

/// A segment: the limit of a thin cylinder that keeps its power. Along a direction at the angle theta to it, a unit of
/// its length emits the radiant intensity K sin(theta). No path finds it by chance.
class LineLight final : public Light {
public:
    /// From `start` along `segment`, which must not be zero; K is `lineic_radiance`, nits times scene units.
    LineLight(const Vec3& start, const Vec3& segment, const Rgb& lineic_radiance);

    [[nodiscard]] Rgb radiance(const LightPoint&, const Vec3&) const override { return {}; }
    [[nodiscard]] Rgb emission(const LightPoint& y, const Vec3& w) const override;
    [[nodiscard]] std::optional<DirectSample> sample_direct(const Vec3& receiver, const Vec2& u) const override;
    [[nodiscard]] double pdf_direct(const Vec3&, const LightPoint&) const override { return 1 / length_; }
    [[nodiscard]] EmissionSample sample_emission(const Vec2& u_point, const Vec2& u_dir) const override;
    [[nodiscard]] EmissionPdf pdf_emission(const LightPoint& y, const Vec3& w) const override;
    [[nodiscard]] Rgb power() const override;
    [[nodiscard]] std::optional<LightBounds> bounds() const override;
    [[nodiscard]] bool delta() const override { return true; }

    /// Before the light is used: its intensity is multiplied by the shaping's factor.
    void shape(const Shaping& shaping);

private:
    [[nodiscard]] LightPoint light_point(double t) const;
    /// As a thin tube emits: by the cosine about a normal of it, all of which are alike. The density sums up to
    /// sin(theta) / pi^2.
    [[nodiscard]] Vec3 thin_tube_direction(double u_normal, const Vec2& u_dir) const;
    [[nodiscard]] double sin_to_axis(const Vec3& w) const { return length(cross(w, frame_.n)); }

    Vec3 start_;
    Vec3 segment_;
    double length_;
    Frame frame_;  ///< about the segment
    Rgb lineic_radiance_;
    std::unique_ptr<const Beam> beam_;  ///< null: not shaped
};

}  // namespace etendue
