#include "film/replicate_sums.h"

#include <algorithm>
#include <limits>

namespace etendue {

ReplicateSums::ReplicateSums(std::size_t pixels) : camera_(pixels) {
    for (std::vector<Rgb>& plane : planes_) plane.resize(pixels);
}

void ReplicateSums::add_splat(std::size_t pixel, const Rgb& value) {
    if (splat_.empty()) splat_.resize(camera_.size());
    splat_[pixel] += value;
}

void ReplicateSums::end_pass(std::uint64_t light_paths) {
    std::vector<Rgb>& plane = planes_[place_of_pass(passes_++).replicate];
    for (std::size_t pixel = 0; pixel < plane.size(); ++pixel) {
        plane[pixel] += camera_[pixel];
        total_ += camera_[pixel];
    }
    std::fill(camera_.begin(), camera_.end(), Rgb());
    if (splat_.empty()) return;
    const double per_light_path = light_paths > 0 ? 1 / static_cast<double>(light_paths) : 0;
    for (std::size_t pixel = 0; pixel < plane.size(); ++pixel) {
        const Rgb value = splat_[pixel] * per_light_path;
        plane[pixel] += value;
        total_ += value;
    }
    std::fill(splat_.begin(), splat_.end(), Rgb());
}

Rgb ReplicateSums::mean(std::size_t pixel) const {
    Rgb sum;
    for (const std::vector<Rgb>& plane : planes_) sum += plane[pixel];
    return sum / static_cast<double>(passes_);
}

Rgb ReplicateSums::mean_of_picture() const {
    return total_ / (static_cast<double>(pixels()) * static_cast<double>(passes_));
}

Rgb ReplicateSums::variance(std::size_t pixel) const {
    const std::uint64_t replicates = std::min(passes_, kReplicates);
    if (replicates < 2) return Rgb(std::numeric_limits<double>::infinity());
    const Rgb center = mean(pixel);
    Rgb deviation;
    for (std::uint64_t r = 0; r < replicates; ++r) {
        const auto n = static_cast<double>(passes_of(r));
        const Rgb off = planes_[r][pixel] / n - center;
        deviation += off * off * n;
    }
    return deviation / (static_cast<double>(replicates - 1) * static_cast<double>(passes_));
}

}  // namespace etendue
