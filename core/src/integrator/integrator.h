#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "film/film_tile.h"
#include "integrator/render_context.h"

namespace etendue {

/// Renders work units. Stateless but for its set-up: any thread may render any unit, with the same result.
class Integrator {
public:
    virtual ~Integrator() = default;
    /// Fills `tile`, which is empty. The image is the mean of the samples plus the splats over all light paths.
    virtual void render(const WorkUnit& unit, FilmTile& tile) const = 0;
    /// Light subpaths in one pass; 0 when none are needed.
    [[nodiscard]] virtual std::uint64_t light_paths_per_pass() const = 0;
    /// Strategies whose images the tiles carry.
    [[nodiscard]] virtual std::vector<Strategy> image_strategies() const { return {}; }
};

[[nodiscard]] std::unique_ptr<Integrator> make_integrator(const RenderContext& context);

}  // namespace etendue
