#pragma once

#include <cstddef>
#include <vector>

#include <etendue/render_settings.h>

#include "integrator/bdpt/strategies.h"

namespace etendue::test {

/// Everything that the weights of one path depend on (theory.md §3). Vertex 0 is on the light, the last on the lens.
struct PathDensities {
    std::vector<double> light;   ///< density of each vertex per area, sampled from the light's side
    std::vector<double> camera;  ///< and from the camera's
    std::vector<bool> delta;     ///< scatters by a delta lobe on this path: takes part in no connection
    double direct = 0;           ///< density of vertex 0 by next-event estimation
    bool light_is_delta = false;
    bool has_lens = false;
    bool one_direction = false;  ///< from infinity to a camera of parallel rays: only the camera knows the direction
};

/// The weight of the strategy with s light vertices, s = 0 ... k + 1, by products over the whole path in logarithms;
/// -1 where the strategy cannot make this path or does not take part.
[[nodiscard]] std::vector<double> oracle_weights(const PathDensities& path, const ActiveStrategies& active,
                                                 MisHeuristic heuristic);

}  // namespace etendue::test
