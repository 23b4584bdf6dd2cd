// A scene somewhere else looks the same. Positions are measured from a grid point next to the scene (world_origin.h),
// before anything is rounded to float: moved by whole steps of the grid it is the same bit for bit.

#include "extremes/extreme.h"
#include "extremes/pictures.h"
#include "extremes/similar_scenes.h"

namespace etendue::test {
namespace {

TEST(Offset, ByStepsOfTheGridIsBitForBitTheSame) {
    const Vec3 offset{0x1p20, -0x1p20, 0x1p19};
    const Worst worst = worst_of_all([&](const SceneDescription& scene, const RenderSettings& settings) {
        // Moved there and back, translations have only digits that the next move leaves them.
        const SceneDescription here = moved(moved(scene, offset), -offset);
        return pixels_that_differ(picture(here, settings), picture(moved(here, offset), settings));
    });
    EXPECT_TRUE(at_most({"offset", "(2^20, -2^20, 2^19), " + worst.where, "the picture: pixels that differ in any bit"},
                        worst.figure, 0));
}

/// As for scales, with coordinates up to four times larger: the grid's nearest point is not the middle of the scene.
TEST(Offset, ByAnythingDiffersByRoundings) {
    for (const double distance : {1.1, 100.3, 1e4, 1e6}) {
        const Vec3 offset{distance, -distance, distance / 3};
        const Worst worst = worst_of_all([&](const SceneDescription& scene, const RenderSettings& settings) {
            return relative_difference(picture(scene, settings), picture(moved(scene, offset), settings));
        });
        EXPECT_TRUE(at_most(
            {"offset", in_words(distance) + " units, worst: " + worst.where, "the picture: relative difference"},
            worst.figure, 0x1p-12));
    }
}

/// Shapes far off in their group, which is brought back by its instances.
TEST(Offset, WithinGroupsDiffersByRoundings) {
    for (const double distance : {100.3, 1e6}) {
        const Vec3 offset{distance, -distance, distance / 3};
        const Worst worst = worst_of_all([&](const SceneDescription& scene, const RenderSettings& settings) {
            if (scene.instances.empty()) return 0.0;
            return relative_difference(picture(scene, settings), picture(moved_within_groups(scene, offset), settings));
        });
        EXPECT_TRUE(at_most(
            {"offset", in_words(distance) + " units within what instances share", "the picture: relative difference"},
            worst.figure, 0x1p-12));
    }
}

}  // namespace
}  // namespace etendue::test
