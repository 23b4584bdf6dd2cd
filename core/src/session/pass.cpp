#include "session/pass.h"

#include <algorithm>

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include "util/hand_over.h"

namespace etendue {
namespace {

/// Small enough to spread over cores and to keep a unit's light vertices in cache, large enough to amortise hand-over.
constexpr int kTileSize = 16;

std::vector<WorkUnit> cut(const PixelWindow& window, std::uint64_t light_paths) {
    std::vector<WorkUnit> units;
    for (int y = window.y0; y < window.y1; y += kTileSize) {
        for (int x = window.x0; x < window.x1; x += kTileSize) {
            WorkUnit unit;
            unit.tile = {x, y, std::min(x + kTileSize, window.x1), std::min(y + kTileSize, window.y1)};
            units.push_back(unit);
        }
    }
    for (std::uint64_t i = 0; i < units.size(); ++i) {
        units[i].light_begin = light_paths * i / units.size();
        units[i].light_end = light_paths * (i + 1) / units.size();
    }
    return units;
}

}  // namespace

PassRunner::PassRunner(const Integrator& integrator, const PixelWindow& window)
    : integrator_(integrator), units_(cut(window, integrator.light_paths_per_pass())) {}

std::vector<PixelWindow> PassRunner::tiles() const {
    std::vector<PixelWindow> tiles;
    tiles.reserve(units_.size());
    for (const WorkUnit& unit : units_) tiles.push_back(unit.tile);
    return tiles;
}

bool PassRunner::run(std::uint64_t pass, const SamplePlan& plan, const std::atomic<bool>& stop,
                     const Sink& sink) const {
    const auto in_flight = static_cast<std::size_t>(4 * tbb::this_task_arena::max_concurrency());
    // Units end in their order, so that one has always ended before another one needs its tile.
    std::vector<FilmTile> tiles(in_flight);
    HandOver hand_over;
    std::size_t next = 0;
    const auto generate = [&](tbb::flow_control& control) -> std::size_t {
        hand_over.take();
        if (next == units_.size() || stop.load(std::memory_order_relaxed)) {
            control.stop();
            return 0;
        }
        const std::size_t unit = next++;
        hand_over.give();
        return unit;
    };
    const auto render = [&](std::size_t unit) {
        hand_over.take();
        FilmTile& tile = tiles[unit % in_flight];
        WorkUnit work = units_[unit];
        work.pass = pass;
        const SampleRange range = plan.samples(pass, unit);
        work.first_sample = range.first;
        work.samples = range.count;
        tile.reset(work.tile);
        tile.number = unit;
        integrator_.render(work, tile);
        hand_over.give();
        return unit;
    };
    const auto deliver = [&](std::size_t unit) {
        hand_over.take();
        sink(tiles[unit % in_flight]);
        hand_over.give();
    };
    hand_over.give();
    tbb::parallel_pipeline(in_flight,
                           tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, generate) &
                               tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, render) &
                               tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_in_order, deliver));
    hand_over.take();
    return next == units_.size();
}

}  // namespace etendue
