#pragma once

#include "light/light.h"

namespace etendue {

/// Light from infinity. A concrete light knows directions and radiance; where its rays enter is a point of the disk
/// that is perpendicular to the direction and as wide as the scene.
class InfiniteLight : public Light {
public:
    [[nodiscard]] std::optional<DirectSample> sample_direct(const Vec3& receiver, const Vec2& u) const override;
    [[nodiscard]] double pdf_direct(const Vec3& receiver, const LightPoint& y) const override;
    [[nodiscard]] EmissionSample sample_emission(const Vec2& u_point, const Vec2& u_dir) const override;
    [[nodiscard]] EmissionPdf pdf_emission(const LightPoint& y, const Vec3& w) const override;
    [[nodiscard]] Rgb power() const override;
    [[nodiscard]] bool infinite() const override { return true; }

protected:
    struct DirectionSample {
        Vec3 to_light;   ///< unit
        Rgb weight;      ///< radiance over pdf; of a delta its irradiance
        double pdf = 0;  ///< per solid angle; 1 for a delta
    };

    explicit InfiniteLight(const SceneBounds& bounds);

    [[nodiscard]] virtual DirectionSample sample_direction(const Vec2& u) const = 0;
    [[nodiscard]] virtual double pdf_direction(const Vec3& to_light) const = 0;
    /// Integral of the radiance over all directions.
    [[nodiscard]] virtual Rgb fluence() const = 0;

private:
    [[nodiscard]] double disk_area() const;

    SceneBounds bounds_;
};

}  // namespace etendue
