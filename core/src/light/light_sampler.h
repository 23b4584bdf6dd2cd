#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "light/light.h"
#include "math/distribution.h"

namespace etendue {

struct LightChoice {
    int light = -1;  ///< index
    double pmf = 0;
};

/// Chooses among lights. Lights of zero power are never chosen.
class LightSampler {
public:
    explicit LightSampler(const std::vector<std::unique_ptr<Light>>& lights);

    /// For a light subpath: by power. Empty when no light emits.
    [[nodiscard]] std::optional<LightChoice> sample_emission(double u) const;
    [[nodiscard]] double pmf_emission(int light) const { return pmf(emission_, light); }

    /// For next-event estimation at `receiver`: half by power, half evenly, so that a weak light nearby is not starved
    /// by a strong one elsewhere. Today the same for every receiver. Empty when no light emits.
    [[nodiscard]] std::optional<LightChoice> sample_direct(const Vec3& receiver, double u) const;
    [[nodiscard]] double pmf_direct(const Vec3& receiver, int light) const;

private:
    [[nodiscard]] static std::optional<LightChoice> choose(const Distribution& distribution, double u);
    [[nodiscard]] static double pmf(const Distribution& distribution, int light);

    Distribution emission_;
    Distribution direct_;
};

}  // namespace etendue
