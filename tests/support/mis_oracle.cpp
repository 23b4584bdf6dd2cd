#include "support/mis_oracle.h"

#include <cmath>

namespace etendue::test {
namespace {

bool takes_part(const PathDensities& path, const ActiveStrategies& active, std::size_t s, std::size_t t) {
    if (path.one_direction && s > 0) return false;
    if (s == 0) return active.emission_hit && !path.light_is_delta;
    if (t == 0) return active.lens_hit && path.has_lens && !(s == 2 && path.light_is_delta);
    // Vertices s - 1 and s are joined: neither may be a delta.
    if (path.delta[s - 1] || path.delta[s]) return false;
    if (t == 1) return active.light_image && !(s == 1 && path.light_is_delta);
    return s == 1 ? active.direct_light : active.connection;
}

/// Logarithm of the density with which strategy s makes the path, times its number of samples.
long double log_density(const PathDensities& path, const ActiveStrategies& active, std::size_t s, std::size_t t) {
    long double sum = 0;
    for (std::size_t i = 0; i < s; ++i) {
        const bool next_event = i == 0 && s == 1 && t >= 2;
        sum += std::log(static_cast<long double>(next_event ? path.direct : path.light[i]));
    }
    for (std::size_t i = s; i < s + t; ++i) sum += std::log(static_cast<long double>(path.camera[i]));
    if (t <= 1) sum += std::log(static_cast<long double>(active.light_paths));
    return sum;
}

}  // namespace

std::vector<double> oracle_weights(const PathDensities& path, const ActiveStrategies& active, MisHeuristic heuristic) {
    const long double beta = heuristic == MisHeuristic::Power ? 2 : 1;
    const std::size_t vertices = path.light.size();
    std::vector<long double> logs(vertices + 1, -INFINITY);
    long double largest = -INFINITY;
    for (std::size_t s = 0; s <= vertices; ++s) {
        const std::size_t t = vertices - s;
        if (!takes_part(path, active, s, t)) continue;
        logs[s] = beta * log_density(path, active, s, t);
        largest = std::max(largest, logs[s]);
    }
    long double total = 0;
    for (long double x : logs) total += std::exp(x - largest);
    std::vector<double> weights;
    for (long double x : logs) {
        weights.push_back(std::isinf(x) ? -1.0 : static_cast<double>(std::exp(x - largest) / total));
    }
    return weights;
}

}  // namespace etendue::test
