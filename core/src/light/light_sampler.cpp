#include "light/light_sampler.h"

#include <cstddef>

namespace etendue {
namespace {

/// All channels count alike: a blue light must not be starved for its low luminance.
double total(const Rgb& power) { return power.r + power.g + power.b; }

std::vector<double> half_even(const std::vector<double>& powers) {
    double sum = 0;
    double lit = 0;
    for (double power : powers) {
        sum += power;
        if (power > 0) lit += 1;
    }
    std::vector<double> weights;
    weights.reserve(powers.size());
    for (double power : powers) weights.push_back(power > 0 ? power / sum + 1 / lit : 0);
    return weights;
}

}  // namespace

LightSampler::LightSampler(const std::vector<std::unique_ptr<Light>>& lights) {
    std::vector<double> powers;
    powers.reserve(lights.size());
    for (const auto& light : lights) powers.push_back(total(light->power()));
    emission_ = Distribution(powers);
    direct_ = Distribution(half_even(powers));
}

std::optional<LightChoice> LightSampler::choose(const Distribution& distribution, double u) {
    if (!(distribution.total() > 0)) return {};
    const std::size_t i = distribution.sample(u).index;
    return LightChoice{static_cast<int>(i), distribution.pmf(i)};
}

double LightSampler::pmf(const Distribution& distribution, int light) {
    return distribution.total() > 0 ? distribution.pmf(static_cast<std::size_t>(light)) : 0;
}

std::optional<LightChoice> LightSampler::sample_emission(double u) const { return choose(emission_, u); }

std::optional<LightChoice> LightSampler::sample_direct(const Vec3&, double u) const { return choose(direct_, u); }

double LightSampler::pmf_direct(const Vec3&, int light) const { return pmf(direct_, light); }

}  // namespace etendue
