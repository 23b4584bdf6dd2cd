#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "film/replicates.h"
#include "math/rgb.h"

namespace etendue {

/// Pixel sums of each replicate, over its complete passes; what the variance of a picture is made of. One plane for
/// each replicate, not one record for each pixel: a pass adds to one of them alone.
///
/// Where pixels differ in their numbers of samples, a replicate's sum is what it would be had each of its passes taken
/// one sample, and each were the mean of those it took.
class ReplicateSums {
public:
    /// `uneven`: whether passes may take any number of samples of a pixel, each replicate at least one.
    explicit ReplicateSums(std::size_t pixels, bool uneven = false);

    void add_sample(std::size_t pixel, const Rgb& radiance) {
        camera_[pixel] += radiance;
        if (!count_.empty()) ++count_[pixel];
    }
    void add_splat(std::size_t pixel, const Rgb& value);
    /// Only what came before it counts. `light_paths`: of the pass.
    void end_pass(std::uint64_t light_paths);

    [[nodiscard]] std::size_t pixels() const { return camera_.size(); }
    /// Bytes, once splats have come, if `splats` do.
    [[nodiscard]] std::size_t memory_used(bool splats) const;
    /// Complete ones.
    [[nodiscard]] std::uint64_t passes() const { return passes_; }
    [[nodiscard]] std::uint64_t passes_of(std::uint64_t replicate) const {
        return passes_of_replicate(replicate, passes_);
    }
    /// Over the passes of one replicate.
    [[nodiscard]] Rgb sum(std::uint64_t replicate, std::size_t pixel) const {
        return count_.empty() ? planes_[replicate][pixel] : uneven_sum(replicate, pixel);
    }
    /// Of camera samples alone, without splats. Needs `uneven` and a pass of the replicate.
    [[nodiscard]] Rgb camera_mean(std::uint64_t replicate, std::size_t pixel) const {
        return planes_[replicate][pixel] / counts_[replicate][pixel];
    }
    /// Over all passes.
    [[nodiscard]] Rgb mean(std::size_t pixel) const;
    /// Over all passes and pixels.
    [[nodiscard]] Rgb mean_of_picture() const;
    /// Of that mean; infinite while fewer than two replicates have passes.
    [[nodiscard]] Rgb variance(std::size_t pixel) const;

private:
    [[nodiscard]] Rgb uneven_sum(std::uint64_t replicate, std::size_t pixel) const;

    std::vector<Rgb> camera_;                           ///< of the present pass
    std::vector<Rgb> splat_;                            ///< likewise; empty until one arrives
    std::vector<std::uint32_t> count_;                  ///< likewise; empty unless uneven, as those of replicates below
    std::array<std::vector<Rgb>, kReplicates> planes_;  ///< if uneven, of camera samples alone
    std::array<std::vector<Rgb>, kReplicates> splats_;  ///< if uneven; empty until one arrives
    std::array<std::vector<std::uint32_t>, kReplicates> counts_;
    Rgb total_;  ///< of all planes; of use unless uneven
    std::uint64_t passes_ = 0;
};

}  // namespace etendue
