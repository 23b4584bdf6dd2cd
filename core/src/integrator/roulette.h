#pragma once

#include <algorithm>

#include "math/rgb.h"
#include "math/sampler.h"

namespace etendue {

/// Russian roulette on how much the path can still carry, relative to its start. Of camera paths that is basic radiance
/// (theory.md §5): `radiance_scale` takes the 1/eta^2 of being inside glass back out. Survivors are divided by the
/// probability, so the estimate stays unbiased; densities in weights leave it out.
class Roulette {
public:
    Roulette(int first_depth, const Rgb& start) : first_depth_(first_depth), start_(max_component(start)) {}

    /// False when the path ends. `depth` counts bounces so far.
    bool survive(int depth, double radiance_scale, Rgb& throughput, Sampler& sampler) const {
        if (first_depth_ < 0 || depth < first_depth_) return true;
        const double left = max_component(throughput);
        if (!(left > 0)) return false;  // a camera of no exposure starts with nothing
        const double carried = left / (radiance_scale * start_);
        const double probability = std::min(carried, kMaxSurvival);
        if (!(sampler.next_1d() < probability)) return false;
        throughput *= 1 / probability;
        return true;
    }

private:
    /// Even a path that loses nothing ends some time: closed furnaces stay finite.
    static constexpr double kMaxSurvival = 0.95;

    int first_depth_;
    double start_;
};

}  // namespace etendue
