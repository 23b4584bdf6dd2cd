#pragma once

#include "light/light.h"

namespace etendue {

/// A surface that emits diffusely from its front. A concrete light samples its points; the default next-event
/// estimate takes any of them, wherever the receiver is.
class AreaLight : public Light {
public:
    [[nodiscard]] Rgb radiance(const LightPoint& y, const Vec3& w) const override;
    [[nodiscard]] std::optional<DirectSample> sample_direct(const Vec3& receiver, const Vec2& u) const override;
    [[nodiscard]] double pdf_direct(const Vec3& receiver, const LightPoint& y) const override;
    [[nodiscard]] EmissionSample sample_emission(const Vec2& u_point, const Vec2& u_dir) const override;
    [[nodiscard]] EmissionPdf pdf_emission(const LightPoint& y, const Vec3& w) const override;
    [[nodiscard]] Rgb power() const override;

protected:
    struct PointSample {
        LightPoint y;
        double pdf = 0;  ///< per area
    };

    AreaLight(const Rgb& radiance, double area) : radiance_(radiance), area_(area) {}

    [[nodiscard]] virtual PointSample sample_point(const Vec2& u) const = 0;
    [[nodiscard]] virtual double pdf_point(const LightPoint& y) const = 0;
    /// Radiance leaving the front at y.
    [[nodiscard]] virtual Rgb emitted(const LightPoint&) const { return radiance_; }

    /// The sample of a known point; empty where the receiver does not see its front.
    [[nodiscard]] std::optional<DirectSample> direct_sample(const Vec3& receiver, const PointSample& point) const;
    [[nodiscard]] static bool faces(const LightPoint& y, const Vec3& receiver) { return dot(receiver - y.p, y.n) > 0; }

    [[nodiscard]] double area() const { return area_; }
    [[nodiscard]] const Rgb& base_radiance() const { return radiance_; }

private:
    Rgb radiance_;
    double area_;
};

}  // namespace etendue
