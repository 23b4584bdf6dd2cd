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
    : settings_(settings),
      filter_(settings.filter),
      window_(window),
      camera_(pixel_index(window, window.x0, window.y1),
              asks_for(settings, {Aov::Alpha, Aov::Depth, Aov::Normal, Aov::Albedo}), places_samples(settings)),
      strategies_(std::move(strategies), window, camera_.parts()) {
    if (keeps_replicates(settings)) replicates_.emplace(camera_.pixels(), places_samples(settings));
}

std::uint64_t Film::replicate() const {
    return place_of_pass(static_cast<std::uint64_t>(statistics_.passes)).replicate;
}

void Film::add(const FilmTile& tile) {
    add_samples(tile);
    if (!tile.splats.empty() && splat_.empty()) splat_.resize(camera_.pixels());
    for (const Splat& splat : tile.splats) add_splat(splat);
    strategies_.add(tile, filter_, camera_.part_of(replicate()));
    statistics_.camera_paths += tile.camera_paths;
    statistics_.light_paths += tile.light_paths;
    statistics_.rays += tile.rays;
    pass_light_paths_ += tile.light_paths;
    for (std::size_t i = 0; i < tile.invalid.size(); ++i) statistics_.invalid[i] += tile.invalid[i];
}

void Film::add_samples(const FilmTile& tile) {
    const std::size_t part = camera_.part_of(replicate());
    auto sample = tile.samples.begin();
    while (sample != tile.samples.end()) {
        for (int y = tile.window.y0; y < tile.window.y1; ++y) {
            for (int x = tile.window.x0; x < tile.window.x1; ++x, ++sample) {
                const std::size_t pixel = pixel_index(window_, x, y);
                camera_.add(part, pixel, *sample);
                if (replicates_) replicates_->add_sample(pixel, sample->radiance);
            }
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
    camera_.end_pass(replicate());
    ++statistics_.passes;
    if (replicates_) replicates_->end_pass(pass_light_paths_);
    pass_light_paths_ = 0;
}

Rgb Film::color(std::size_t pixel) const {
    Rgb value = camera_.radiance(pixel) / camera_.samples(pixel);
    if (!splat_.empty()) value += splat_[pixel] / static_cast<double>(statistics_.light_paths);
    return value;
}

std::size_t Film::memory_used(bool light_paths) const {
    const std::size_t splats = light_paths ? camera_.pixels() * sizeof(Rgb) : 0;
    const std::size_t replicates = replicates_ ? replicates_->memory_used(light_paths) : 0;
    return camera_.memory_used() + splats + replicates + strategies_.memory_used();
}

bool Film::shows_error() const { return replicates_ && replicates_->passes() >= kReplicates; }

RelativeError Film::relative_error() const { return {*replicates_, window_.x1 - window_.x0}; }

CameraNoise Film::camera_noise(std::uint64_t half) const { return {*replicates_, window_, half}; }

void Film::fill(Aov aov, std::span<float> out) const {
    for (std::size_t pixel = 0; pixel < camera_.pixels(); ++pixel) {
        switch (aov) {
            case Aov::Color:
                store(out, pixel, color(pixel));
                break;
            case Aov::Alpha:
                store(out, pixel, camera_.surface(pixel).hits / camera_.samples(pixel));
                break;
            case Aov::Depth: {
                const CameraSums::Surface surface = camera_.surface(pixel);
                store(out, pixel,
                      surface.hits > 0 ? surface.depth / surface.hits : std::numeric_limits<double>::infinity());
                break;
            }
            case Aov::Normal: {
                const CameraSums::Surface surface = camera_.surface(pixel);
                const Vec3 n = surface.hits > 0 ? surface.normal / surface.hits : Vec3();
                store(out, pixel, Rgb(n.x, n.y, n.z));
                break;
            }
            case Aov::Albedo:
                store(out, pixel, camera_.surface(pixel).albedo / camera_.samples(pixel));
                break;
            case Aov::SampleCount:
                store(out, pixel, static_cast<double>(camera_.count(pixel)));
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
        out.data.resize(camera_.pixels() * static_cast<std::size_t>(out.channels));
        fill(aov, out.data);
    }
    image.strategy_images = strategies_.images(camera_, statistics_.light_paths);
    return image;
}

}  // namespace etendue
