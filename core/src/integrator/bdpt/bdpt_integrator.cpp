#include "integrator/bdpt/bdpt_integrator.h"

#include <algorithm>
#include <cmath>

#include "integrator/first_surface.h"
#include "integrator/needed_draws.h"

namespace etendue {
namespace {

std::uint64_t pixel_count(const PixelWindow& window) {
    return static_cast<std::uint64_t>(window.x1 - window.x0) * static_cast<std::uint64_t>(window.y1 - window.y0);
}

/// Measured on the stages by efficiency: caustics want many light subpaths, and nothing else wants one by the pixel.
double light_paths_per_pixel(const RenderContext& context) {
    if (const auto& asked = context.settings.light_paths_per_pixel) return *asked;
    const StrategySet& active = context.strategies;
    if (!active.emission_hit && !active.direct_light && !active.connection) return 1;
    return context.scene.emission().has_targets() ? 4 : 0.5;
}

std::uint64_t count_light_paths(const RenderContext& context) {
    const auto pixels = static_cast<double>(pixel_count(context.window));
    const double wanted = pixels * light_paths_per_pixel(context);
    // The smallest crop has one: without any, what only light paths see would be missing.
    return wanted > 0 ? static_cast<std::uint64_t>(std::max(1LL, std::llround(wanted))) : 0;
}

ActiveStrategies resolve(const RenderContext& context) {
    const StrategySet& carrying = context.strategies;
    ActiveStrategies active{carrying.emission_hit, carrying.direct_light, carrying.connection, carrying.light_image,
                            carrying.lens_hit};
    if (active.needs_light_paths()) active.light_paths = static_cast<double>(count_light_paths(context));
    return active;
}

}  // namespace

// The tracer and the connector keep references to the members before them.
BdptIntegrator::BdptIntegrator(const RenderContext& context)
    : context_(context),
      active_(resolve(context)),
      streams_(context.settings.seed, static_cast<std::uint64_t>(active_.light_paths)),
      tracer_(context_, active_),
      connector_(context_, active_) {
    const int longest = std::min(context_.settings.strategy_images, context_.settings.max_depth + 1);
    if (longest > 0) images_.emplace(active_, longest);
}

std::uint64_t BdptIntegrator::light_paths_per_pass() const {
    return active_.needs_light_paths() ? static_cast<std::uint64_t>(active_.light_paths) : 0;
}

std::vector<Strategy> BdptIntegrator::image_strategies() const {
    return images_ ? images_->strategies() : std::vector<Strategy>{};
}

void BdptIntegrator::render(const WorkUnit& unit, FilmTile& tile) const {
    // Kept between units: no allocation per path.
    thread_local LightSubpath light;
    thread_local CameraSubpath camera;
    light.clear();
    const std::uint64_t pixels = pixel_count(unit.tile);
    tile.samples.resize(pixels * unit.samples);
    const std::uint64_t paths = unit.light_end - unit.light_begin;
    if (paths == 0 && active_.connection && unit.samples > 0) {
        // Fewer light paths than units: this one's camera paths are joined to the path that another unit splats.
        Sampler sampler = streams_.light(unit.pass, unit.light_begin);
        tracer_.trace_light(sampler, light, tile.rays);
    }
    std::uint64_t traced = 0;
    for (std::uint64_t pixel = 0; pixel < pixels; ++pixel) {
        // Light paths are spread over the pixels, rounded up so that the first has one; a camera path is joined to the
        // latest. The samples of one pixel are joined to different ones: each sweep over the tile is at another place.
        const std::uint64_t wanted = (paths * (pixel + 1) + pixels - 1) / pixels;
        trace_light_paths(unit, unit.light_begin + traced, unit.light_begin + wanted, light, tile);
        traced = wanted;
        const std::uint64_t rays = tile.rays;
        for (std::uint64_t sweep = 0; sweep < unit.samples; ++sweep) {
            const std::uint64_t ahead = sweep * pixels / unit.samples;
            sample_camera(unit, sweep * pixels + (pixel + ahead) % pixels, light, camera, tile);
        }
        tile.camera_rays += tile.rays - rays;
    }
}

void BdptIntegrator::trace_light_paths(const WorkUnit& unit, std::uint64_t begin, std::uint64_t end, LightSubpath& path,
                                       FilmTile& tile) const {
    for (std::uint64_t i = begin; i < end; ++i) {
        Sampler sampler = streams_.light(unit.pass, i);
        tracer_.trace_light(sampler, path, tile.rays);
        splat_light_path(path, sampler, tile);
        ++tile.light_paths;
    }
}

void BdptIntegrator::splat_light_path(const LightSubpath& path, Sampler& sampler, FilmTile& tile) const {
    for (const LensCrossing& crossing : path.crossings) splat(connector_.lens_hit(crossing), crossing.s, 0, tile);
    if (!active_.light_image || !path.start) return;
    splat(connector_.start_to_lens(*path.start, sampler, tile.rays), 1, 1, tile);
    for (std::size_t i = 0; i < path.vertices.size(); ++i) {
        const Vertex& y = path.vertices[i];
        if (y.connectible()) splat(connector_.to_lens(y, sampler, tile.rays), static_cast<int>(i) + 2, 1, tile);
    }
}

void BdptIntegrator::sample_camera(const WorkUnit& unit, std::size_t sample, const LightSubpath& light,
                                   CameraSubpath& camera, FilmTile& tile) const {
    if (!active_.needs_camera_paths() && !context_.wants_surface) return;
    const std::size_t pixel = sample % pixel_count(unit.tile);
    const std::uint64_t number = unit.first_sample + sample / pixel_count(unit.tile);
    const auto width = static_cast<std::size_t>(unit.tile.x1 - unit.tile.x0);
    const int x = unit.tile.x0 + static_cast<int>(pixel % width);
    const int y = unit.tile.y0 + static_cast<int>(pixel / width);
    Sampler sampler = streams_.camera(unit.pass, pixel_number(context_, x, y), number);
    const Vec2 offset = context_.filter.sample(sampler.next_2d());
    const Vec2 raster{x + 0.5 + offset.x, y + 0.5 + offset.y};
    ++tile.camera_paths;
    if (!active_.needs_camera_paths()) {
        record_first_surface(raster, sampler, tile.samples[sample], tile);
        return;
    }
    tracer_.trace_camera(raster, sampler, camera, tile.rays);
    if (!camera.vertices.empty()) {
        const Vertex& first = camera.vertices.front();
        record_surface(context_, camera.origin, -first.wo, first.si, tile.samples[sample]);
    }
    Sampler joins = streams_.joins(unit.pass, pixel_number(context_, x, y), number);
    add_camera_strategies(camera, light, joins, sample, tile);
}

void BdptIntegrator::record_first_surface(const Vec2& raster, Sampler& sampler, PixelSample& sample,
                                          FilmTile& tile) const {
    const CameraRay ray = context_.camera.generate_ray(raster, draw_lens(context_, sampler));
    ++tile.rays;
    const auto si = context_.scene.intersect({offset_origin(ray.origin, {}, {}, ray.direction), ray.direction});
    record_surface(context_, ray.origin, ray.direction, si, sample);
}

void BdptIntegrator::add_camera_strategies(const CameraSubpath& camera, const LightSubpath& light, Sampler& sampler,
                                           std::size_t sample, FilmTile& tile) const {
    const int longest = context_.settings.max_depth + 2;  // s + t
    for (std::size_t i = 0; i < camera.vertices.size(); ++i) {
        const Vertex& z = camera.vertices[i];
        const int t = static_cast<int>(i) + 2;
        if (active_.emission_hit) add(connector_.emission(camera, i), 0, t, sample, tile);
        if (!z.connectible() || t + 1 > longest) continue;
        if (active_.direct_light) add(connector_.direct(z, sampler, tile.rays), 1, t, sample, tile);
        if (!active_.connection) continue;
        const std::size_t count = std::min(light.vertices.size(), static_cast<std::size_t>(longest - t - 1));
        for (std::size_t j = 0; j < count; ++j) {
            const Vertex& y = light.vertices[j];
            if (y.connectible()) add(connector_.connect(y, z, tile.rays), static_cast<int>(j) + 2, t, sample, tile);
        }
    }
    if (!active_.emission_hit || !camera.escape) return;
    for (int index : context_.scene.infinite_lights()) {
        add(connector_.infinite_emission(*camera.escape, index), 0, camera.escape->t, sample, tile);
    }
}

Rgb BdptIntegrator::weigh(const Contribution& c, int s, int t) const {
    const auto& single = context_.settings.single_strategy;
    if (!single) return c.value * c.weight;
    return single->s == s && single->t == t ? c.value : Rgb{};
}

void BdptIntegrator::add(const std::optional<Contribution>& c, int s, int t, std::size_t sample, FilmTile& tile) const {
    if (!c) return;
    const Rgb value = weigh(*c, s, t);
    if (!tile.accept(value)) return;
    tile.samples[sample].radiance += value;
    if (images_) images_->add_sample(*c, s, t, sample, tile);
}

void BdptIntegrator::splat(const std::optional<Contribution>& c, int s, int t, FilmTile& tile) const {
    if (!c) return;
    const Rgb value = weigh(*c, s, t);
    if (tile.add_splat(c->raster, value) && images_) images_->add_splat(*c, s, t, tile);
}

}  // namespace etendue
