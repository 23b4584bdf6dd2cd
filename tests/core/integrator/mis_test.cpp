// The O(1) weights against a brute-force oracle: on random densities, where all strategies of one path must also add up
// to one, and on real paths, where the oracle computes every density anew from the path's geometry.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "integrator/bdpt/weights.h"
#include "math/rng.h"
#include "support/mis_oracle.h"

namespace etendue::test {
namespace {

/// A path with random densities per area, random delta vertices, and geometry factors of its own.
struct RandomPath {
    PathDensities p;
    std::vector<double> area;  ///< area[i]: turns densities per solid angle at a neighbour into densities per area at i
    ActiveStrategies active;
};

double spread(Rng& rng, double decades) { return std::pow(10.0, decades * (2 * rng.next_1d() - 1)); }

RandomPath random_path(Rng& rng, double decades) {
    RandomPath r;
    const auto vertices = static_cast<std::size_t>(2 + static_cast<int>(rng.next_1d() * 7));
    for (std::size_t i = 0; i < vertices; ++i) {
        r.p.light.push_back(spread(rng, decades));
        r.p.camera.push_back(spread(rng, decades));
        const bool end = i == 0 || i + 1 == vertices;
        r.p.delta.push_back(!end && rng.next_1d() < 0.3);
        r.area.push_back(spread(rng, decades));
    }
    r.p.direct = spread(rng, decades);
    const auto flag = [&rng] { return rng.next_1d() < 0.8; };
    r.p.light_is_delta = !flag();
    r.p.has_lens = flag();
    r.active = {.emission_hit = flag(),
                .direct_light = flag(),
                .connection = flag(),
                .light_image = flag(),
                .lens_hit = r.p.has_lens && flag(),
                .light_paths = std::round(spread(rng, 3)) + 1};
    return r;
}

/// Rebuilds the states that SubpathTracer keeps, from densities alone.
class StateBuilder {
public:
    StateBuilder(const RandomPath& path, const Heuristic& h) : path_(path), h_(h), k_(path.p.light.size() - 1) {}

    /// State of light vertex i >= 1.
    [[nodiscard]] MisState light(std::size_t i) const {
        const auto& [p, area, active] = path_;
        MisState state;
        state.connect = 1 / h_(p.light[1]);
        state.adjacent = active.direct_light ? h_(p.direct / p.light[0]) : 0;
        if (active.emission_hit && !p.light_is_delta) state.deeper = h_(area[0] / (p.light[0] * p.light[1]));
        for (std::size_t j = 1; j < i; ++j) {
            state = advance(state, h_, p.delta[j], p.camera[j - 1] / area[j - 1], area[j], p.light[j + 1],
                            active.connection ? 1 : 0);
        }
        return state;
    }
    /// State of path vertex i < k as a camera vertex.
    [[nodiscard]] MisState camera(std::size_t i) const {
        const auto& [p, area, active] = path_;
        const double n = active.light_paths;
        MisState state;
        state.connect = 1 / h_(p.camera[k_ - 1]);
        state.adjacent = active.light_image ? h_(n) : 0;
        if (active.lens_hit) state.deeper = h_(n * area[k_] / (p.camera[k_] * p.camera[k_ - 1]));
        for (std::size_t j = k_ - 1; j > i; --j) {
            state = advance(state, h_, p.delta[j], p.light[j + 1] / area[j + 1], area[j], p.camera[j - 1],
                            active.connection ? 1 : 0);
        }
        return state;
    }

    /// Weight of the strategy with s light vertices by weights.h.
    [[nodiscard]] double weight(std::size_t s) const {
        const auto& [p, area, active] = path_;
        const std::size_t t = k_ + 1 - s;
        const LightDensities light{p.direct, p.light[0], p.light[1] / area[1]};
        const double lens_ratio = active.lens_hit ? p.light[k_] / p.camera[k_] : 0;
        const bool hit = active.emission_hit && !p.light_is_delta;
        if (s == 0) return weight_emission_hit(h_, camera(0), light, t == 2, active.direct_light);
        if (t == 0) {
            return weight_lens_hit(h_, this->light(k_), p.camera[k_], p.camera[k_ - 1] / area[k_ - 1],
                                   active.light_paths, active.light_image);
        }
        if (s == 1 && t == 1) {
            return weight_light_image_of_start(h_, hit ? p.camera[0] / p.light[0] : 0, active.light_paths, lens_ratio);
        }
        if (t == 1) {
            return weight_light_image(h_, this->light(s - 1), p.camera[s - 1], p.camera[s - 2] / area[s - 2],
                                      active.light_paths, lens_ratio);
        }
        if (s == 1) {
            return weight_direct_light(h_, camera(1), light, hit ? p.camera[0] : 0, area[1], p.light[2] / area[2]);
        }
        return weight_connection(h_, this->light(s - 1), p.camera[s - 1], p.camera[s - 2] / area[s - 2], camera(s),
                                 p.light[s], p.light[s + 1] / area[s + 1]);
    }

private:
    const RandomPath& path_;
    const Heuristic& h_;
    std::size_t k_;
};

void check_random_paths(MisHeuristic kind, double decades) {
    const Heuristic h(kind);
    Rng rng(1, static_cast<std::uint64_t>(kind), static_cast<std::uint64_t>(decades));
    int checked = 0;
    for (int i = 0; i < 20000; ++i) {
        const RandomPath path = random_path(rng, decades);
        const StateBuilder states(path, h);
        const std::vector<double> expected = oracle_weights(path.p, path.active, kind);
        double sum = 0;
        for (std::size_t s = 0; s < expected.size(); ++s) {
            if (expected[s] < 0) continue;  // not a strategy of this path
            const double w = states.weight(s);
            // Each weight is a product of a few dozen roundings.
            ASSERT_NEAR(w, expected[s], 1e-12) << "path " << i << ", s = " << s;
            sum += w;
            ++checked;
        }
        if (sum > 0) {
            ASSERT_NEAR(sum, 1, 1e-12) << "path " << i;
        }
    }
    EXPECT_GT(checked, 20000);
}

TEST(Weights, EqualTheOracleAndSumToOneOnRandomDensities) {
    for (const MisHeuristic kind : {MisHeuristic::Balance, MisHeuristic::Power}) {
        check_random_paths(kind, 2);
        check_random_paths(kind, 15);  // squares overflow float long before
    }
}

}  // namespace
}  // namespace etendue::test
