#include "session/sample_plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "session/wanted_samples.h"

namespace etendue {
namespace {

constexpr double kGoldenRatio = 0.6180339887498949;
/// Doubles have no more bits to find.
constexpr int kBisections = 64;

double pixel_count(const PixelWindow& w) { return static_cast<double>(w.x1 - w.x0) * (w.y1 - w.y0); }

}  // namespace

SamplePlan::SamplePlan(std::vector<PixelWindow> tiles) : tiles_(std::move(tiles)) {
    for (const PixelWindow& tile : tiles_) {
        pixels_.push_back(pixel_count(tile));
        dither_.push_back(std::fmod(static_cast<double>(pixels_.size()) * kGoldenRatio, 1));
    }
    for (Half& half : halves_) {
        half.camera_rays.resize(tiles_.size());
        half.light_rays.resize(tiles_.size());
    }
}

void SamplePlan::count(std::uint64_t pass, const FilmTile& tile) {
    const PassPlace place = place_of_pass(pass);
    if (place.index >= kEvenRounds) return;
    Half& half = halves_[half_of_replicate(place.replicate)];
    half.camera_rays[tile.number] += static_cast<double>(tile.camera_rays);
    half.light_rays[tile.number] += static_cast<double>(tile.rays - tile.camera_rays);
}

void SamplePlan::decide(std::uint64_t half, const CameraNoise& seen_by_other) {
    Half& h = halves_[half];
    const Half& other = halves_[kHalves - 1 - half];
    constexpr std::uint64_t kPasses = kEvenRounds * kReplicates / kHalves;
    std::vector<TileReport> reports;
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        const double samples = static_cast<double>(kPasses) * pixels_[i];
        reports.push_back(
            {pixels_[i], seen_by_other.of(tiles_[i]), other.camera_rays[i] / samples, other.light_rays[i] / samples});
    }
    h.wanted = wanted_samples(reports);
    h.after.assign(tiles_.size(), kEvenRounds);
    take_round(h);
}

void SamplePlan::begin(std::uint64_t pass, const Film& film) {
    const std::uint64_t index = place_of_pass(pass).index;
    if (index < kEvenRounds) return;
    if (round_ < kEvenRounds) {
        round_ = kEvenRounds;
        for (std::uint64_t half = 0; half < kHalves; ++half) decide(half, film.camera_noise(kHalves - 1 - half));
    } else if (round_ < index) {
        ++round_;
        for (Half& half : halves_) take_round(half);
    }
}

void SamplePlan::take_round(Half& half) const {
    half.before = half.after;
    const auto mean = static_cast<double>(round_ + 1);
    const auto after = [&](std::size_t tile, double level) {
        const double least = std::max(half.before[tile], kLeastSamples * mean);
        return std::clamp(level * half.wanted[tile], least, half.before[tile] + kMostAtOnce);
    };
    const auto reaches = [&](double level) {
        double samples = 0;
        for (std::size_t tile = 0; tile < tiles_.size(); ++tile) samples += pixels_[tile] * after(tile, level);
        return samples >= mean * std::accumulate(pixels_.begin(), pixels_.end(), 0.0);
    };
    double low = 0;
    double high = 1;
    while (!reaches(high)) high *= 2;  // does so once all tiles get the most that they can in a round
    for (int i = 0; i < kBisections; ++i) {
        const double level = (low + high) / 2;
        (reaches(level) ? high : low) = level;
    }
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile) half.after[tile] = after(tile, high);
}

SampleRange SamplePlan::samples(std::uint64_t pass, std::size_t tile) const {
    const PassPlace place = place_of_pass(pass);
    const Half& half = halves_[half_of_replicate(place.replicate)];
    if (half.wanted.empty() || place.index < kEvenRounds) return {place.index, 1};
    const auto first = static_cast<std::uint64_t>(half.before[tile] + dither_[tile]);
    return {first, static_cast<std::uint64_t>(half.after[tile] + dither_[tile]) - first};
}

}  // namespace etendue
