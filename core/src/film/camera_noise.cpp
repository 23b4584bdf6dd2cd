#include "film/camera_noise.h"

#include <algorithm>
#include <vector>

#include <etendue/film_view.h>

#include "film/splat_footprint.h"

namespace etendue {
namespace {

double gray(const Rgb& c) { return total(c) * (1.0 / 3); }

}  // namespace

CameraNoise::CameraNoise(const ReplicateSums& sums, const PixelWindow& window, std::uint64_t half)
    : sums_(sums), window_(window) {
    for (std::uint64_t r = 0, member = 0; r < kReplicates; ++r) {
        if (half_of_replicate(r) == half) members_[member++] = r;
    }
    double sum = 0;
    for (std::size_t pixel = 0; pixel < sums.pixels(); ++pixel) sum += look(pixel).mean;
    const double darkest = kDarkestPart * sum / static_cast<double>(sums.pixels());
    darkest_squared_ = darkest * darkest;
}

CameraNoise::View CameraNoise::look(std::size_t pixel) const {
    std::array<Rgb, kMembers> camera;
    std::array<Rgb, kMembers> splats;
    Rgb camera_mean;
    Rgb splat_mean;
    for (std::size_t i = 0; i < kMembers; ++i) {
        const std::uint64_t replicate = members_[i];
        camera[i] = sums_.camera_mean(replicate, pixel);
        splats[i] = sums_.sum(replicate, pixel) / static_cast<double>(sums_.passes_of(replicate)) - camera[i];
        camera_mean += camera[i] / kMembers;
        splat_mean += splats[i] / kMembers;
    }
    constexpr double kDegrees = kMembers - 1;
    View view;
    view.mean = gray(camera_mean + splat_mean);
    for (std::size_t i = 0; i < kMembers; ++i) {
        const Rgb camera_off = camera[i] - camera_mean;
        const Rgb splats_off = splats[i] - splat_mean;
        const double off = gray(camera_off + splats_off);
        const double passes = static_cast<double>(sums_.passes_of(members_[i])) / kDegrees;
        view.camera += gray(camera_off * camera_off) * passes;
        view.splats += gray(splats_off * splats_off) * passes;
        view.noise += off * off / (kDegrees * kMembers);
    }
    return view;
}

TileNoise CameraNoise::of(const PixelWindow& tile) const {
    std::vector<View> views;
    double mean = 0;
    double squares = 0;
    double noise = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const View view = look(pixel_index(window_, x, y));
            mean += view.mean;
            squares += view.mean * view.mean;
            noise += view.noise;
            views.push_back(view);
        }
    }
    const double per_pixel = 1 / static_cast<double>(views.size());
    mean *= per_pixel;
    const double scatter = squares * per_pixel - mean * mean;
    // Wiener's filter with the tile as its window, as in RelativeError.
    const double kept = scatter > 0 ? std::max(0.0, 1 - noise * per_pixel / scatter) : 0;
    TileNoise seen;
    for (const View& view : views) {
        const double bright = mean + kept * (view.mean - mean);
        const double scale = bright * bright + darkest_squared_;
        if (!(scale > 0)) continue;  // all is black, and nothing varies
        seen.camera += view.camera / scale * per_pixel;
        seen.splats += view.splats / scale * per_pixel;
    }
    return seen;
}

}  // namespace etendue
