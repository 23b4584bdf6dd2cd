#pragma once

#include "bsdf/fresnel.h"
#include "bsdf/specular_albedo.h"
#include "math/constants.h"

namespace etendue {

/// Light that GGX facets of a metal reflect more than once, as a lobe L(wo) L(wi) / (pi L_mean) of what single
/// scattering loses, L = 1 - E (Kulla and Conty 2017): symmetric, and with it white metal loses little but the table's
/// margin, where it lost 69 % at alpha 1 along the normal. Sampled by the cosine.
class MultipleScattering {
public:
    explicit MultipleScattering(double alpha) : alpha_(alpha), exists_(alpha > kMultipleScatteringAlpha) {}

    [[nodiscard]] bool exists() const { return exists_; }

    /// For a white metal and directions on the same side; times reflectance() for any.
    [[nodiscard]] double value(double cos_o, double cos_i) const {
        return lost_albedo(cos_o, alpha_) * lost_albedo(cos_i, alpha_) * kInvPi / mean_lost_albedo(alpha_);
    }

    /// What is left of light after two or more reflections, each of the mean reflectance F, when the part `lost` of it
    /// goes on after each: F^2 (1 - lost) / (1 - F lost).
    [[nodiscard]] Rgb reflectance(const SchlickFresnel& fresnel) const {
        const Rgb mean = fresnel.mean();
        const double lost = mean_lost_albedo(alpha_);
        const auto channel = [lost](double f) { return f * f * (1 - lost) / (1 - f * lost); };
        return {channel(mean.r), channel(mean.g), channel(mean.b)};
    }

private:
    double alpha_;
    bool exists_;
};

}  // namespace etendue
