#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "film/film_tile.h"
#include "film/replicates.h"

namespace etendue {

/// Sums of what camera samples tell, pixel by pixel.
///
/// Where all pixels have the same samples, a pixel is the mean of its own. Where samples go where the noise is
/// (RenderSettings::adaptive) the halves are kept apart, and a pixel is the mean of their means, each weighted with the
/// number of its passes, whatever the number of its samples: see session/sample_plan.h for why.
class CameraSums {
public:
    /// What the first surfaces met add up to.
    struct Surface {
        double hits = 0;
        double depth = 0;
        Vec3 normal;
        Rgb albedo;
    };

    /// `surfaces`: whether an AOV asks for them. `halves`: whether pixels will differ in their numbers of samples.
    CameraSums(std::size_t pixels, bool surfaces, bool halves);

    void add(std::size_t part, std::size_t pixel, const PixelSample& sample) {
        Part& sums = parts_[part];
        sums.radiance[pixel] += sample.radiance;
        ++sums.count[pixel];
        if (sums.surface.empty() || !sample.hit) return;
        Surface& surface = sums.surface[pixel];
        surface.hits += 1;
        surface.depth += sample.depth;
        surface.normal += sample.normal;
        surface.albedo += sample.albedo;
    }
    void end_pass(std::uint64_t replicate);

    [[nodiscard]] std::size_t pixels() const { return parts_.front().radiance.size(); }
    /// Bytes.
    [[nodiscard]] std::size_t memory_used() const;
    /// Sums are kept in so many parts: one, or one for each half.
    [[nodiscard]] std::size_t parts() const { return parts_.size(); }
    [[nodiscard]] std::size_t part_of(std::uint64_t replicate) const {
        return parts_.size() == 1 ? 0 : half_of_replicate(replicate);
    }
    /// By what a part's sum over samples is multiplied ...
    [[nodiscard]] double weight(std::size_t part, std::size_t pixel) const;
    /// ... and by what the parts together are divided. Not 0.
    [[nodiscard]] double samples(std::size_t pixel) const;
    /// Taken in fact.
    [[nodiscard]] std::uint64_t count(std::size_t pixel) const;

    /// Weighted.
    [[nodiscard]] Rgb radiance(std::size_t pixel) const;
    /// Weighted.
    [[nodiscard]] Surface surface(std::size_t pixel) const;

private:
    struct Part {
        std::vector<Rgb> radiance;
        std::vector<std::uint32_t> count;
        std::vector<Surface> surface;  ///< empty unless asked for
        std::uint64_t passes = 0;      ///< complete ones
    };

    /// So far each sample counts alike.
    [[nodiscard]] bool even() const { return parts_.size() == 1 || passes_ <= kEvenRounds * kReplicates; }

    std::vector<Part> parts_;
    std::uint64_t passes_ = 0;
};

}  // namespace etendue
