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
class ReplicateSums {
public:
    explicit ReplicateSums(std::size_t pixels);

    void add_sample(std::size_t pixel, const Rgb& radiance) { camera_[pixel] += radiance; }
    void add_splat(std::size_t pixel, const Rgb& value);
    /// Only what came before it counts. `light_paths`: of the pass.
    void end_pass(std::uint64_t light_paths);

    [[nodiscard]] std::size_t pixels() const { return camera_.size(); }
    /// Complete ones.
    [[nodiscard]] std::uint64_t passes() const { return passes_; }
    [[nodiscard]] std::uint64_t passes_of(std::uint64_t replicate) const {
        return passes_of_replicate(replicate, passes_);
    }
    /// Over the passes of one replicate.
    [[nodiscard]] const Rgb& sum(std::uint64_t replicate, std::size_t pixel) const { return planes_[replicate][pixel]; }
    /// Over all passes.
    [[nodiscard]] Rgb mean(std::size_t pixel) const;
    /// Over all passes and pixels.
    [[nodiscard]] Rgb mean_of_picture() const;
    /// Of that mean; infinite while fewer than two replicates have passes.
    [[nodiscard]] Rgb variance(std::size_t pixel) const;

private:
    std::vector<Rgb> camera_;  ///< of the present pass
    std::vector<Rgb> splat_;   ///< likewise; empty until one arrives
    std::array<std::vector<Rgb>, kReplicates> planes_;
    Rgb total_;  ///< of all planes
    std::uint64_t passes_ = 0;
};

}  // namespace etendue
