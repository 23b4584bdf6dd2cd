#pragma once

#include "light/light.h"

namespace etendue {

/// Stands in for a light that cannot emit (no area), so that the lights keep the indices of the description. Its
/// power is zero: no sampler chooses it.
class DarkLight final : public Light {
public:
    [[nodiscard]] Rgb radiance(const LightPoint&, const Vec3&) const override { return {}; }
    [[nodiscard]] std::optional<DirectSample> sample_direct(const Vec3&, const Vec2&) const override { return {}; }
    [[nodiscard]] double pdf_direct(const Vec3&, const LightPoint&) const override { return 0; }
    [[nodiscard]] EmissionSample sample_emission(const Vec2&, const Vec2&) const override { return {}; }
    [[nodiscard]] EmissionPdf pdf_emission(const LightPoint&, const Vec3&) const override { return {}; }
    [[nodiscard]] Rgb power() const override { return {}; }
};

}  // namespace etendue
