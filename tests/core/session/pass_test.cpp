// Tiles reach the film in one fixed order, whichever thread is done first: sums of doubles depend on it, if seldom by
// enough to show in a picture of floats.

#include "session/pass.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace etendue::test {
namespace {

/// Takes longest for the units that come first.
class Dawdler final : public Integrator {
public:
    void render(const WorkUnit& unit, FilmTile& tile) const override {
        std::this_thread::sleep_for(std::chrono::milliseconds(unit.tile.x0 % 64 == 0 ? 5 : 0));
        tile.light_paths = unit.light_end - unit.light_begin;
    }
    [[nodiscard]] std::uint64_t light_paths_per_pass() const override { return 1000; }
};

constexpr PixelWindow kWindow{0, 0, 100, 70};
constexpr std::size_t kUnits = 7 * 5;

struct Seen {
    std::vector<PixelWindow> tiles;
    std::uint64_t light_paths = 0;
};

bool comes_after(const PixelWindow& a, const PixelWindow& b) { return a.y0 > b.y0 || (a.y0 == b.y0 && a.x0 > b.x0); }

TEST(Pass, TilesArriveInOrderFromAnyThread) {
    // Threads that sleep need no core of their own.
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
    tbb::task_arena arena(4);
    const Dawdler dawdler;
    const PassRunner runner(dawdler, kWindow);
    const std::atomic<bool> stop{false};
    Seen seen;
    arena.execute([&] {
        EXPECT_TRUE(runner.run(0, SamplePlan(runner.tiles()), stop, [&](const FilmTile& tile) {
            seen.tiles.push_back(tile.window);
            seen.light_paths += tile.light_paths;
        }));
    });
    ASSERT_EQ(seen.tiles.size(), kUnits);
    for (std::size_t i = 1; i < kUnits; ++i) EXPECT_TRUE(comes_after(seen.tiles[i], seen.tiles[i - 1])) << i;
    EXPECT_EQ(seen.light_paths, 1000U);
    int pixels = 0;
    for (const PixelWindow& w : seen.tiles) pixels += (w.x1 - w.x0) * (w.y1 - w.y0);
    EXPECT_EQ(pixels, 7000);
}

TEST(Pass, StoppedPassesAreBeginnings) {
    const Dawdler dawdler;
    const PassRunner runner(dawdler, kWindow);
    std::atomic<bool> stop{false};
    std::size_t tiles = 0;
    tbb::task_arena arena(2);
    arena.execute([&] {
        EXPECT_FALSE(
            runner.run(0, SamplePlan(runner.tiles()), stop, [&](const FilmTile&) { stop = ++tiles == 3 || stop; }));
    });
    EXPECT_GE(tiles, 3U);
    EXPECT_LT(tiles, kUnits);
}

}  // namespace
}  // namespace etendue::test
