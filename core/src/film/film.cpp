#include "film/film.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "film/splat_footprint.h"
#include "util/asks_for.h"

namespace etendue {
namespace {

void store(std::span<float> out, std::size_t pixel, double value) { out[pixel] = static_cast<float>(value); }

void store(std::span<float> out, std::size_t pixel, const Rgb& value) {
    out[3 * pixel] = static_cast<float>(value.r);
    out[3 * pixel + 1] = static_cast<float>(value.g);
    out[3 * pixel + 2] = static_cast<float>(value.b);
}

}  // namespace

Film::Film(const RenderSettings& settings, const PixelWindow& window, std::vector<Strategy> strategies)
    : settings_(settings), filter_(settings.filter), window_(window), strategies_(std::move(strategies), window) {
    const auto pixels =
        static_cast<std::size_t>(window.x1 - window.x0) * static_cast<std::size_t>(window.y1 - window.y0);
    camera_.resize(pixels);
    count_.resize(pixels);
    if (asks_for(settings, {Aov::Alpha, Aov::Depth, Aov::Normal, Aov::Albedo})) surface_.resize(pixels);
    if (keeps_replicates(settings)) replicates_.emplace(pixels);
}

void Film::add(const FilmTile& tile) {
    add_samples(tile);
    if (!tile.splats.empty() && splat_.empty()) splat_.resize(camera_.size());
    for (const Splat& splat : tile.splats) add_splat(splat);
    strategies_.add(tile, filter_);
    statistics_.camera_paths += tile.camera_paths;
    statistics_.light_paths += tile.light_paths;
    statistics_.rays += tile.rays;
    pass_light_paths_ += tile.light_paths;
    for (std::size_t i = 0; i < tile.invalid.size(); ++i) statistics_.invalid[i] += tile.invalid[i];
}

void Film::add_samples(const FilmTile& tile) {
    auto sample = tile.samples.begin();
    for (int y = tile.window.y0; y < tile.window.y1; ++y) {
        for (int x = tile.window.x0; x < tile.window.x1; ++x, ++sample) {
            const std::size_t pixel = pixel_index(window_, x, y);
            camera_[pixel] += sample->radiance;
            ++count_[pixel];
            if (replicates_) replicates_->add_sample(pixel, sample->radiance);
            if (surface_.empty() || !sample->hit) continue;
            SurfaceSums& sums = surface_[pixel];
            sums.hits += 1;
            sums.depth += sample->depth;
            sums.normal += sample->normal;
            sums.albedo += sample->albedo;
        }
    }
}

void Film::add_splat(const Splat& splat) {
    spread_splat(filter_, window_, splat.raster, [&](std::size_t pixel, double weight) {
        splat_[pixel] += splat.value * weight;
        if (replicates_) replicates_->add_splat(pixel, splat.value * weight);
    });
}

void Film::end_pass() {
    ++statistics_.passes;
    if (replicates_) replicates_->end_pass(pass_light_paths_);
    pass_light_paths_ = 0;
}

Rgb Film::color(std::size_t pixel) const {
    Rgb value;
    if (count_[pixel] > 0) value += camera_[pixel] / count_[pixel];
    if (!splat_.empty()) value += splat_[pixel] / static_cast<double>(statistics_.light_paths);
    return value;
}

std::size_t Film::memory_used(bool light_paths) const {
    const std::size_t plane = camera_.size() * sizeof(Rgb);
    const std::size_t splats = light_paths ? plane : 0;
    const std::size_t replicates = replicates_ ? kReplicates * plane + plane + splats : 0;
    return plane + splats + count_.size() * sizeof(count_[0]) + surface_.size() * sizeof(SurfaceSums) + replicates +
           strategies_.memory_used();
}

bool Film::shows_error() const { return replicates_ && replicates_->passes() >= kReplicates; }

RelativeError Film::relative_error() const { return {*replicates_, window_.x1 - window_.x0}; }

void Film::fill(Aov aov, std::span<float> out) const {
    for (std::size_t pixel = 0; pixel < camera_.size(); ++pixel) {
        const double samples = std::max<std::uint32_t>(count_[pixel], 1);
        switch (aov) {
            case Aov::Color:
                store(out, pixel, color(pixel));
                break;
            case Aov::Alpha:
                store(out, pixel, surface_[pixel].hits / samples);
                break;
            case Aov::Depth:
                store(out, pixel,
                      surface_[pixel].hits > 0 ? surface_[pixel].depth / surface_[pixel].hits
                                               : std::numeric_limits<double>::infinity());
                break;
            case Aov::Normal: {
                const Vec3 n = surface_[pixel].normal / std::max(surface_[pixel].hits, 1.0);
                store(out, pixel, Rgb(n.x, n.y, n.z));
                break;
            }
            case Aov::Albedo:
                store(out, pixel, surface_[pixel].albedo / samples);
                break;
            case Aov::SampleCount:
                store(out, pixel, static_cast<double>(count_[pixel]));
                break;
            case Aov::Variance:
                store(out, pixel, replicates_->variance(pixel));
                break;
        }
    }
}

RenderedImage Film::image() const {
    RenderedImage image;
    image.width = window_.x1 - window_.x0;
    image.height = window_.y1 - window_.y0;
    image.window = window_;
    image.full_width = settings_.width;
    image.full_height = settings_.height;
    image.statistics = statistics_;
    for (Aov aov : settings_.aovs) {
        AovImage& out = image.aovs.emplace_back();
        out.aov = aov;
        out.channels = aov_channels(aov);
        out.data.resize(camera_.size() * static_cast<std::size_t>(out.channels));
        fill(aov, out.data);
    }
    image.strategy_images = strategies_.images(count_, statistics_.light_paths);
    return image;
}

}  // namespace etendue
