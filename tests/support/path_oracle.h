#pragma once

#include <vector>

#include "bsdf/bsdf.h"
#include "integrator/bdpt/strategies.h"
#include "integrator/render_context.h"
#include "light/light.h"
#include "support/mis_oracle.h"

namespace etendue::test {

/// A surface vertex of a whole path, with the lobe it scatters by.
struct PathVertex {
    Vec3 p;
    Vec3 n_g;
    const Bsdf* bsdf = nullptr;  ///< needed unless it is the light's own point
    bool delta = false;
};

/// A whole path, however it was made: a point on a light, surfaces, a point on the lens.
struct WholePath {
    int light = -1;
    LightPoint y;
    std::vector<PathVertex> surfaces;
    Vec3 lens;
};

/// Computes every density of the path anew from its geometry.
[[nodiscard]] PathDensities path_densities(const WholePath& path, const RenderContext& context);

}  // namespace etendue::test
