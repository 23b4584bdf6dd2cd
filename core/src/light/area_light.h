#pragma once

#include <memory>

#include "light/beam.h"
#include "light/light.h"

namespace etendue {

/// A surface that emits from its front: diffusely, or shaped. A concrete light samples its points; the default
/// next-event estimate takes any of them, wherever the receiver is.
class AreaLight : public Light {
public:
    [[nodiscard]] Rgb radiance(const LightPoint& y, const Vec3& w) const override;
    [[nodiscard]] std::optional<DirectSample> sample_direct(const Vec3& receiver, const Vec2& u) const override;
    [[nodiscard]] double pdf_direct(const Vec3& receiver, const LightPoint& y) const override;
    [[nodiscard]] EmissionSample sample_emission(const Vec2& u_point, const Vec2& u_dir) const override;
    [[nodiscard]] EmissionPdf pdf_emission(const LightPoint& y, const Vec3& w) const override;
    [[nodiscard]] Rgb power() const override;

    /// Before the light is used: its radiance is multiplied by the shaping's factor.
    void shape(const Shaping& shaping);

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

    /// Its mean over the area.
    [[nodiscard]] virtual Rgb mean_emitted() const { return radiance_; }
    /// What tells the area seen from afar, or about what; never nothing where anything is seen. Lives as long as the
    /// light.
    [[nodiscard]] virtual Beam::Silhouette silhouette() const = 0;
    /// The normal of a flat light; zero when there are many.
    [[nodiscard]] virtual Vec3 flat_normal() const { return {}; }
    /// `bounds` of the plain light, with the cone of a narrow shaping.
    [[nodiscard]] LightBounds shaped_bounds(LightBounds bounds) const;

    /// The sample of a known point; empty where the receiver does not see its front.
    [[nodiscard]] std::optional<DirectSample> direct_sample(const Vec3& receiver, const PointSample& point) const;
    [[nodiscard]] static bool faces(const LightPoint& y, const Vec3& receiver) { return dot(receiver - y.p, y.n) > 0; }

    [[nodiscard]] double area() const { return area_; }
    [[nodiscard]] const Rgb& base_radiance() const { return radiance_; }

private:
    /// Radiance along w, which must be in front.
    [[nodiscard]] Rgb emitted_along(const LightPoint& y, const Vec3& w) const;
    [[nodiscard]] double pdf_emission_direction(const Vec3& n, const Vec3& w) const;

    Rgb radiance_;
    double area_;
    std::unique_ptr<const Beam> beam_;  ///< null: not shaped
    bool emits_by_beam_ = false;        ///< directions are chosen by it, not by the cosine
};

}  // namespace etendue
