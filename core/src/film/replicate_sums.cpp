#include "film/replicate_sums.h"

#include <algorithm>
#include <limits>

namespace etendue {

ReplicateSums::ReplicateSums(std::size_t pixels, bool uneven) : camera_(pixels) {
    for (std::vector<Rgb>& plane : planes_) plane.resize(pixels);
    if (!uneven) return;
    count_.resize(pixels);
    for (std::vector<std::uint32_t>& counts : counts_) counts.resize(pixels);
}

void ReplicateSums::add_splat(std::size_t pixel, const Rgb& value) {
    if (splat_.empty()) splat_.resize(camera_.size());
    splat_[pixel] += value;
}

void ReplicateSums::end_pass(std::uint64_t light_paths) {
    const std::uint64_t replicate = place_of_pass(passes_++).replicate;
    std::vector<Rgb>& plane = planes_[replicate];
    for (std::size_t pixel = 0; pixel < plane.size(); ++pixel) {
        plane[pixel] += camera_[pixel];
        total_ += camera_[pixel];
    }
    std::fill(camera_.begin(), camera_.end(), Rgb());
    std::vector<std::uint32_t>& counts = counts_[replicate];
    for (std::size_t pixel = 0; pixel < count_.size(); ++pixel) counts[pixel] += count_[pixel];
    std::fill(count_.begin(), count_.end(), 0);
    if (splat_.empty()) return;
    std::vector<Rgb>& splats = count_.empty() ? plane : splats_[replicate];
    splats.resize(plane.size());
    const double per_light_path = light_paths > 0 ? 1 / static_cast<double>(light_paths) : 0;
    for (std::size_t pixel = 0; pixel < plane.size(); ++pixel) {
        const Rgb value = splat_[pixel] * per_light_path;
        splats[pixel] += value;
        total_ += value;
    }
    std::fill(splat_.begin(), splat_.end(), Rgb());
}

std::size_t ReplicateSums::memory_used(bool splats) const {
    const std::size_t plane = camera_.size() * sizeof(Rgb);
    const std::size_t counts = (kReplicates + 1) * count_.size() * sizeof(count_[0]);
    const std::size_t splat_planes = !splats ? 0 : (count_.empty() ? 1 : kReplicates + 1);
    return (kReplicates + 1 + splat_planes) * plane + counts;
}

Rgb ReplicateSums::uneven_sum(std::uint64_t replicate, std::size_t pixel) const {
    if (passes_of(replicate) == 0) return {};
    Rgb sum = camera_mean(replicate, pixel) * static_cast<double>(passes_of(replicate));
    if (!splats_[replicate].empty()) sum += splats_[replicate][pixel];
    return sum;
}

Rgb ReplicateSums::mean(std::size_t pixel) const {
    Rgb sum;
    for (std::uint64_t replicate = 0; replicate < kReplicates; ++replicate) sum += this->sum(replicate, pixel);
    return sum / static_cast<double>(passes_);
}

Rgb ReplicateSums::mean_of_picture() const {
    const auto pixels = static_cast<double>(this->pixels());
    if (count_.empty()) return total_ / (pixels * static_cast<double>(passes_));
    Rgb sum;
    for (std::size_t pixel = 0; pixel < this->pixels(); ++pixel) sum += mean(pixel);
    return sum / pixels;
}

Rgb ReplicateSums::variance(std::size_t pixel) const {
    const std::uint64_t replicates = std::min(passes_, kReplicates);
    if (replicates < 2) return Rgb(std::numeric_limits<double>::infinity());
    const Rgb center = mean(pixel);
    Rgb deviation;
    for (std::uint64_t r = 0; r < replicates; ++r) {
        const auto n = static_cast<double>(passes_of(r));
        const Rgb off = sum(r, pixel) / n - center;
        deviation += off * off * n;
    }
    return deviation / (static_cast<double>(replicates - 1) * static_cast<double>(passes_));
}

}  // namespace etendue
