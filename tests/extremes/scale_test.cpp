// A scene made larger or smaller as a whole looks the same. By a power of two every number of the render is the same
// but for its exponent, so the picture is the same bit for bit; by another factor positions round anew in float. It
// ends where Embree's products of lengths leave float's range: with 2^-24 or 2^40 the first pixels differ.

#include <algorithm>

#include "extremes/extreme.h"
#include "extremes/pictures.h"
#include "extremes/similar_scenes.h"

namespace etendue::test {
namespace {

TEST(Scale, ByPowersOfTwoIsBitForBitTheSame) {
    const Worst worst = worst_of_all([](const SceneDescription& scene, const RenderSettings& settings) {
        const Picture original = picture(scene, settings);
        EXPECT_GT(original.mean(), 0);
        int different = 0;
        for (const double scale : {0x1p-22, 0x1p-20, 0x1p20, 0x1p36}) {
            different += pixels_that_differ(original, picture(scaled(scene, scale), settings));
        }
        return different;
    });
    EXPECT_TRUE(
        at_most({"scale", "2^-22, 2^-20, 2^20 and 2^36, " + worst.where, "the picture: pixels that differ in any bit"},
                worst.figure, 0));
}

/// A position rounds by 2^-24 of itself; 2^10 of these are left for roundings per hit, bounces, and what curved
/// surfaces make of them.
TEST(Scale, ByOtherFactorsDiffersByRoundings) {
    for (const double scale : {1e-6, 3e-4, 1e3, 1e6}) {
        const Worst worst = worst_of_all([scale](const SceneDescription& scene, const RenderSettings& settings) {
            return relative_difference(picture(scene, settings), picture(scaled(scene, scale), settings));
        });
        EXPECT_TRUE(at_most({"scale", in_words(scale) + ", worst: " + worst.where, "the picture: relative difference"},
                            worst.figure, 0x1p-14));
    }
}

}  // namespace
}  // namespace etendue::test
