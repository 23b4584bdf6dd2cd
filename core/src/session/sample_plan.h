#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <etendue/render_settings.h>

#include "film/camera_noise.h"
#include "film/film.h"
#include "film/film_tile.h"
#include "film/replicates.h"

namespace etendue {

/// Numbers [first, first + count) of a pixel's samples in a replicate.
struct SampleRange {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};

/// How many samples each pass takes of the pixels of each tile (RenderSettings::adaptive).
///
/// Who lets a pixel's own samples decide whether it gets more of them is wrong in the mean: a pixel that has met its
/// bright light early gets many that dilute it, one that has not is left as dark as it looks. So the replicates form
/// two halves, A and B, which have no random number in common. Both begin with kEvenRounds samples a pixel in each
/// replicate. Then, once and for all, the numbers for A are decided from what B has seen by then, and those for B from
/// what A has seen; numbers of passes, the pixels' places and constants are all else that they depend on. Given what B
/// has seen, A's numbers are fixed ones, and A's samples are what they always were: the mean of n samples, n fixed, has
/// the pixel's value as its expectation. It has it whatever B has seen, hence also without regard to it. The same holds
/// for B. A picture that weighs A and B with their numbers of passes, which nobody has seen anything to choose
/// (CameraSums), is therefore right in the mean: exactly, at every number of passes, for whatever rule makes numbers of
/// what was seen. Splats have no part in it: passes trace their light paths as ever, and all are divided by their
/// number. Camera samples are joined to light paths of their own pass, which is of their own half.
///
/// Deciding again later would have to look at a half whose numbers of samples the other half's samples have changed:
/// A's numbers would then depend on A's samples, through B. That is why there is one decision.
///
/// What remains is what any render has that ends when its noise looks small (ErrorWatch), or by the clock.
///
/// The rule (wanted_samples.h) says in which proportion tiles are to have samples. A pass takes one a pixel in the
/// mean, and those that a tile has had already count: until the noisiest have caught up, the calm ones wait. But none
/// falls below kLeastSamples, should noise have been overlooked, and none gets more than kMostAtOnce in a pass, so that
/// passes spread over threads.
class SamplePlan {
public:
    /// One sample a pass of each pixel, until decided otherwise.
    explicit SamplePlan(std::vector<PixelWindow> tiles);

    /// Before every pass, in their order; `film` has the passes before it. Without, all passes are even.
    void begin(std::uint64_t pass, const Film& film);
    /// Every tile of the pass, for what its samples cost.
    void count(std::uint64_t pass, const FilmTile& tile);

    [[nodiscard]] SampleRange samples(std::uint64_t pass, std::size_t tile) const;

private:
    static constexpr double kMostAtOnce = 16;

    /// Numbers of samples a pixel, tile by tile.
    struct Half {
        std::vector<double> wanted;  ///< in proportion, 1 at most; empty until decided
        std::vector<double> before;  ///< the present round of passes; whole numbers of them are taken
        std::vector<double> after;
        std::vector<double> camera_rays;  ///< that its even passes took
        std::vector<double> light_rays;
    };

    /// What a half is to do, from what the other one has seen.
    void decide(std::uint64_t half, const CameraNoise& seen_by_other);
    /// Sets what there is to be after the present round.
    void take_round(Half& half) const;

    std::vector<PixelWindow> tiles_;
    std::vector<double> pixels_;  ///< of each tile
    std::vector<double> dither_;  ///< lets tiles round up in different rounds
    std::array<Half, kHalves> halves_;
    std::uint64_t round_ = 0;  ///< PassPlace::index of the present passes; 0 while they are even
};

}  // namespace etendue
