#pragma once

#include <memory>

#include "light/beam.h"
#include "light/light.h"

namespace etendue {

/// A point that emits `intensity` candela (in scene units: E = I / d^2) in every direction, or shaped.
class PointLight final : public Light {
public:
    PointLight(const Vec3& position, const Rgb& intensity) : position_(position), intensity_(intensity) {}

    [[nodiscard]] Rgb radiance(const LightPoint&, const Vec3&) const override { return {}; }
    [[nodiscard]] Rgb emission(const LightPoint&, const Vec3& w) const override {
        return beam_ ? intensity_ * beam_->factor(w) : intensity_;
    }
    [[nodiscard]] std::optional<DirectSample> sample_direct(const Vec3& receiver, const Vec2& u) const override;
    [[nodiscard]] double pdf_direct(const Vec3&, const LightPoint&) const override { return 1; }
    [[nodiscard]] EmissionSample sample_emission(const Vec2& u_point, const Vec2& u_dir) const override;
    [[nodiscard]] EmissionPdf pdf_emission(const LightPoint& y, const Vec3& w) const override;
    [[nodiscard]] Rgb power() const override;
    [[nodiscard]] std::optional<LightBounds> bounds() const override;
    [[nodiscard]] bool delta() const override { return true; }

    /// Before the light is used: its intensity is multiplied by the shaping's factor.
    void shape(const Shaping& shaping);

private:
    [[nodiscard]] LightPoint light_point() const;

    Vec3 position_;
    Rgb intensity_;
    std::unique_ptr<const Beam> beam_;  ///< null: not shaped
};

}  // namespace etendue
