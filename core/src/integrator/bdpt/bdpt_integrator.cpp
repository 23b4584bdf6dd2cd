#include "integrator/bdpt/bdpt_integrator.h"

#include <algorithm>
#include <cmath>

#include "integrator/first_surface.h"
#include "integrator/needed_draws.h"

namespace etendue {
namespace {

/// Measured on the stages by efficiency: caustics want many light subpaths, and nothing else wants one by the pixel.
double light_paths_per_pixel(const RenderContext& context, bool camera_paths) {
    if (const auto& asked = context.settings.light_paths_per_pixel) return *asked;
    if (!camera_paths) return 1;
    return context.scene.emission().has_targets() ? 4 : 0.5;
}

std::uint64_t count_light_paths(const RenderContext& context, bool camera_paths) {
    const PixelWindow& w = context.window;
    const double pixels = static_cast<double>(w.x1 - w.x0) * (w.y1 - w.y0);
    const double wanted = pixels * light_paths_per_pixel(context, camera_paths);
    // The smallest crop has one: without any, what only light paths see would be missing.
    return wanted > 0 ? static_cast<std::uint64_t>(std::max(1LL, std::llround(wanted))) : 0;
}

ActiveStrategies resolve(const RenderContext& context, const StrategySet& asked) {
    ActiveStrategies active;
    active.emission_hit = asked.emission_hit;
    active.direct_light = asked.direct_light;
    const bool camera_paths = asked.emission_hit || asked.direct_light || asked.connection;
    const std::uint64_t paths = context.scene.light_count() > 0 ? count_light_paths(context, camera_paths) : 0;
    if (paths > 0) {
        active.connection = asked.connection;
        active.light_image = asked.light_image;
        active.lens_hit = asked.lens_hit && context.camera.has_lens();
        active.light_paths = static_cast<double>(paths);
    }
    return active;
}

}  // namespace

// The tracer and the connector keep references to the members before them.
BdptIntegrator::BdptIntegrator(const RenderContext& context, const StrategySet& strategies)
    : context_(context),
      active_(resolve(context, strategies)),
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
    const std::uint64_t pixels = static_cast<std::uint64_t>(unit.tile.x1 - unit.tile.x0) *
                                 static_cast<std::uint64_t>(unit.tile.y1 - unit.tile.y0);
    const std::uint64_t paths = unit.light_end - unit.light_begin;
    if (paths == 0 && active_.connection) {
        // Fewer light paths than units: this one's camera paths are joined to the path that another unit splats.
        Sampler sampler = streams_.light(unit.pass, unit.light_begin);
        tracer_.trace_light(sampler, light, tile.rays);
    }
    std::uint64_t pixel = 0;
    std::uint64_t traced = 0;
    for (int y = unit.tile.y0; y < unit.tile.y1; ++y) {
        for (int x = unit.tile.x0; x < unit.tile.x1; ++x, ++pixel) {
            // Light paths are spread over the pixels, rounded up so that the first has one; a camera path is joined to
            // the latest.
            const std::uint64_t wanted = (paths * (pixel + 1) + pixels - 1) / pixels;
            trace_light_paths(unit, unit.light_begin + traced, unit.light_begin + wanted, light, tile);
            traced = wanted;
            sample_camera(x, y, unit.pass, light, camera, tile);
        }
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

void BdptIntegrator::sample_camera(int x, int y, std::uint64_t pass, const LightSubpath& light, CameraSubpath& camera,
                                   FilmTile& tile) const {
    PixelSample sample;
    if (active_.needs_camera_paths() || context_.wants_surface) {
        Sampler sampler = streams_.camera(pass, pixel_number(context_, x, y));
        const Vec2 offset = context_.filter.sample(sampler.next_2d());
        const Vec2 raster{x + 0.5 + offset.x, y + 0.5 + offset.y};
        ++tile.camera_paths;
        if (!active_.needs_camera_paths()) {
            record_first_surface(raster, sampler, sample, tile);
            tile.samples.push_back(sample);
            return;
        }
        tracer_.trace_camera(raster, sampler, camera, tile.rays);
        if (!camera.vertices.empty()) {
            const Vertex& first = camera.vertices.front();
            record_surface(context_, camera.origin, -first.wo, first.si, sample);
        }
        Sampler joins = streams_.joins(pass, pixel_number(context_, x, y));
        add_camera_strategies(camera, light, joins, sample, tile);
    }
    tile.samples.push_back(sample);
}

void BdptIntegrator::record_first_surface(const Vec2& raster, Sampler& sampler, PixelSample& sample,
                                          FilmTile& tile) const {
    const CameraRay ray = context_.camera.generate_ray(raster, draw_lens(context_, sampler));
    ++tile.rays;
    const auto si = context_.scene.intersect({offset_origin(ray.origin, {}, {}, ray.direction), ray.direction});
    record_surface(context_, ray.origin, ray.direction, si, sample);
}

void BdptIntegrator::add_camera_strategies(const CameraSubpath& camera, const LightSubpath& light, Sampler& sampler,
                                           PixelSample& sample, FilmTile& tile) const {
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

void BdptIntegrator::add(const std::optional<Contribution>& c, int s, int t, PixelSample& sample,
                         FilmTile& tile) const {
    if (!c) return;
    const Rgb value = weigh(*c, s, t);
    if (!tile.accept(value)) return;
    sample.radiance += value;
    if (images_) images_->add_sample(*c, s, t, tile);
}

void BdptIntegrator::splat(const std::optional<Contribution>& c, int s, int t, FilmTile& tile) const {
    if (!c) return;
    const Rgb value = weigh(*c, s, t);
    if (tile.add_splat(c->raster, value) && images_) images_->add_splat(*c, s, t, tile);
}

}  // namespace etendue
