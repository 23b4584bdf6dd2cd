#include "film/camera_sums.h"

#include <algorithm>

namespace etendue {

CameraSums::CameraSums(std::size_t pixels, bool surfaces, bool halves) : parts_(halves ? kHalves : 1) {
    for (Part& part : parts_) {
        part.radiance.resize(pixels);
        part.count.resize(pixels);
        if (surfaces) part.surface.resize(pixels);
    }
}

void CameraSums::end_pass(std::uint64_t replicate) {
    ++parts_[part_of(replicate)].passes;
    ++passes_;
}

std::size_t CameraSums::memory_used() const {
    std::size_t bytes = 0;
    for (const Part& part : parts_) {
        bytes += part.radiance.size() * sizeof(Rgb) + part.count.size() * sizeof(part.count[0]) +
                 part.surface.size() * sizeof(Surface);
    }
    return bytes;
}

double CameraSums::weight(std::size_t part, std::size_t pixel) const {
    if (even()) return 1;
    return static_cast<double>(parts_[part].passes) / static_cast<double>(parts_[part].count[pixel]);
}

double CameraSums::samples(std::size_t pixel) const {
    const std::uint64_t samples = even() ? count(pixel) : passes_;
    return static_cast<double>(std::max<std::uint64_t>(samples, 1));
}

std::uint64_t CameraSums::count(std::size_t pixel) const {
    std::uint64_t count = 0;
    for (const Part& part : parts_) count += part.count[pixel];
    return count;
}

Rgb CameraSums::radiance(std::size_t pixel) const {
    Rgb sum;
    for (std::size_t part = 0; part < parts_.size(); ++part) sum += parts_[part].radiance[pixel] * weight(part, pixel);
    return sum;
}

CameraSums::Surface CameraSums::surface(std::size_t pixel) const {
    Surface sum;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        const Surface& surface = parts_[part].surface[pixel];
        const double weight = this->weight(part, pixel);
        sum.hits += weight * surface.hits;
        sum.depth += weight * surface.depth;
        sum.normal += surface.normal * weight;
        sum.albedo += surface.albedo * weight;
    }
    return sum;
}

}  // namespace etendue
