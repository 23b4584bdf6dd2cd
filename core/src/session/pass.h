#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "film/film_tile.h"
#include "integrator/integrator.h"
#include "session/sample_plan.h"

namespace etendue {

/// Cuts passes into work units and runs them on TBB's threads. Tiles reach the sink one at a time in a fixed order,
/// whatever thread rendered them: sums of floating-point numbers then come out the same to the last bit.
class PassRunner {
public:
    PassRunner(const Integrator& integrator, const PixelWindow& window);

    /// What each of them covers, in the order in which they reach the sink.
    [[nodiscard]] std::vector<PixelWindow> tiles() const;

    using Sink = std::function<void(const FilmTile&)>;
    /// False when `stop` ended it early; the sink has then seen the first so many tiles.
    bool run(std::uint64_t pass, const SamplePlan& plan, const std::atomic<bool>& stop, const Sink& sink) const;

private:
    const Integrator& integrator_;
    std::vector<WorkUnit> units_;
};

}  // namespace etendue
