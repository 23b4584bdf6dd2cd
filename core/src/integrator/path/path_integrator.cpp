#include "integrator/path/path_integrator.h"

#include <cmath>

#include "integrator/first_surface.h"
#include "integrator/needed_draws.h"
#include "integrator/roulette.h"
#include "math/constants.h"
#include "math/measure.h"

namespace etendue {

/// The path so far: the vertex it left, and how.
struct PathIntegrator::Walk {
    Ray ray;
    Vec3 from;             ///< the previous vertex
    Rgb beta;              ///< throughput up to and including the last sampled direction
    double pdf = 0;        ///< of that direction, per solid angle
    bool specular = true;  ///< next-event estimation could not have made it: from the lens, or by a delta lobe
    int depth = 0;         ///< bounces so far
    Media media{};         ///< through which the ray goes; only where there is absorption
};

PathIntegrator::PathIntegrator(const RenderContext& context)
    : context_(context), heuristic_(context.settings.heuristic), streams_(context.settings.seed, 0) {}

void PathIntegrator::render(const WorkUnit& unit, FilmTile& tile) const {
    for (std::uint64_t i = unit.first_sample; i < unit.first_sample + unit.samples; ++i) {
        if (context_.scene.absorbs()) {
            sample_pixels<true>(unit, i, tile);
        } else {
            sample_pixels<false>(unit, i, tile);
        }
    }
    tile.camera_rays = tile.rays;
}

template <bool Absorbs>
void PathIntegrator::sample_pixels(const WorkUnit& unit, std::uint64_t number, FilmTile& tile) const {
    for (int y = unit.tile.y0; y < unit.tile.y1; ++y) {
        for (int x = unit.tile.x0; x < unit.tile.x1; ++x) {
            Sampler sampler = streams_.camera(unit.pass, pixel_number(context_, x, y), number);
            const Vec2 offset = context_.filter.sample(sampler.next_2d());
            tile.samples.push_back(sample_pixel<Absorbs>({x + 0.5 + offset.x, y + 0.5 + offset.y}, sampler, tile));
            ++tile.camera_paths;
        }
    }
}

template <bool Absorbs>
PixelSample PathIntegrator::sample_pixel(const Vec2& raster, Sampler& sampler, FilmTile& tile) const {
    PixelSample sample;
    const RenderSettings& settings = context_.settings;
    const CameraRay first = context_.camera.generate_ray(raster, draw_lens(context_, sampler));
    Walk walk{{offset_origin(first.origin, {}, {}, first.direction), first.direction}, first.origin, Rgb(first.weight)};
    const Absorption& absorption = context_.scene.absorption();
    if constexpr (Absorbs) walk.media = context_.camera_media;
    const Roulette roulette(settings.roulette_depth, walk.beta);
    double radiance_scale = 1;
    for (;; ++walk.depth) {
        ++tile.rays;
        const std::optional<SurfaceInteraction> si = context_.scene.intersect(walk.ray);
        if (walk.depth == 0) record_surface(context_, first.origin, first.direction, si, sample);
        if (!si) {
            if constexpr (Absorbs) walk.beta *= absorption.transmittance(walk.media, kInfinity);
            add_infinite(walk, sample, tile);
            break;
        }
        if (!arrives(walk.from, si->p, si->n_g)) break;
        if constexpr (Absorbs) walk.beta *= absorption.transmittance(walk.media, length(si->p - walk.from));
        if (si->light >= 0) add_emission(*si, walk, sample, tile);
        if (walk.depth >= settings.max_depth || !Scene::scatters(*si)) break;
        const Bsdf bsdf = context_.scene.bsdf(*si);
        if (context_.strategies.direct_light && bsdf.connectible()) {
            add_direct<Absorbs>(*si, bsdf, walk, sampler, sample, tile);
        }

        const double u_lobe = sampler.next_1d();
        const auto scattered =
            bsdf.sample(-walk.ray.direction, u_lobe, sampler.next_2d(), TransportMode::Radiance, settings.adjoint);
        if (!scattered) break;
        walk.beta *= scattered->weight;
        radiance_scale *= scattered->radiance_scale;
        if (!roulette.survive(walk.depth + 1, radiance_scale, walk.beta, sampler)) break;
        if constexpr (Absorbs) walk.media = absorption.beyond(walk.media, *si, -walk.ray.direction, scattered->wi);
        walk.from = si->p;
        walk.pdf = scattered->pdf_fwd;
        walk.specular = scattered->delta;
        walk.ray = {offset_origin(si->p, si->p_error, si->n_g, scattered->wi), scattered->wi};
    }
    return sample;
}

double PathIntegrator::hit_weight(const Walk& walk, double pdf_hit, double pdf_direct) const {
    if (walk.specular || !context_.strategies.direct_light) return 1;
    return 1 / (1 + heuristic_(pdf_direct / pdf_hit));
}

void PathIntegrator::add_emission(const SurfaceInteraction& si, const Walk& walk, PixelSample& sample,
                                  FilmTile& tile) const {
    if (!context_.strategies.emission_hit) return;
    const Light& light = context_.scene.light(si.light);
    const LightPoint y{si.p, si.n_g, si.st, si.p_error};
    const Rgb radiance = light.radiance(y, -walk.ray.direction);
    if (is_black(radiance)) return;
    const double pdf_direct =
        context_.scene.light_sampler().pmf_direct(walk.from, si.light) * light.pdf_direct(walk.from, y);
    const double pdf_hit = walk.pdf * area_per_solid_angle(walk.from, si.p, si.n_g);
    const Rgb value = walk.beta * radiance * hit_weight(walk, pdf_hit, pdf_direct);
    if (tile.accept(value)) sample.radiance += value;
}

void PathIntegrator::add_infinite(const Walk& walk, PixelSample& sample, FilmTile& tile) const {
    if (!context_.strategies.emission_hit) return;
    for (int index : context_.scene.infinite_lights()) {
        const Light& light = context_.scene.light(index);
        const LightPoint y{walk.ray.direction, -walk.ray.direction, {}, {}};
        const Rgb radiance = light.radiance(y, -walk.ray.direction);
        if (is_black(radiance)) continue;
        const double pdf_direct =
            context_.scene.light_sampler().pmf_direct(walk.from, index) * light.pdf_direct(walk.from, y);
        const Rgb value = walk.beta * radiance * hit_weight(walk, walk.pdf, pdf_direct);
        if (tile.accept(value)) sample.radiance += value;
    }
}

template <bool Absorbs>
void PathIntegrator::add_direct(const SurfaceInteraction& si, const Bsdf& bsdf, const Walk& walk, Sampler& sampler,
                                PixelSample& sample, FilmTile& tile) const {
    const auto choice = context_.scene.light_sampler().sample_direct(si.p, draw_light(context_, sampler));
    const Vec2 u = sampler.next_2d();
    if (!choice) return;
    const Light& light = context_.scene.light(choice->light);
    const auto direct = light.sample_direct(si.p, u);
    if (!direct) return;
    const Vec3 wo = -walk.ray.direction;
    const Rgb f = bsdf.eval_cos(wo, direct->wi, TransportMode::Radiance, context_.settings.adjoint);
    Rgb value = walk.beta * f * direct->weight / choice->pmf;
    if constexpr (Absorbs) {
        const Media media = context_.scene.absorption().beyond(walk.media, si, wo, direct->wi);
        value *= context_.scene.absorption().transmittance(media, direct->distance);
    }
    if (is_black(value)) return;
    if (!light.delta() && context_.strategies.emission_hit) {
        const double to_native = light.infinite() ? 1 : area_per_solid_angle(si.p, direct->y.p, direct->y.n);
        const double pdf_hit = bsdf.pdf(wo, direct->wi) * to_native;
        value *= 1 / (1 + heuristic_(pdf_hit / (choice->pmf * direct->pdf_point)));
    }
    ++tile.rays;
    const RayEnd here = RayEnd::on(si);
    const bool open = light.infinite() ? context_.scene.sees_infinity(here, direct->wi)
                                       : context_.scene.visible(here, RayEnd::on(direct->y));
    if (open && tile.accept(value)) sample.radiance += value;
}

}  // namespace etendue
