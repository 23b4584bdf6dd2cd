#include "integrator/bdpt/subpath.h"

#include <cmath>

#include "integrator/needed_draws.h"
#include "integrator/roulette.h"
#include "math/constants.h"
#include "math/measure.h"

namespace etendue {

/// The ray that is looking for the next vertex, and what is known of the one it left.
struct SubpathTracer::Walk {
    Ray ray;
    Vec3 from;
    Vec3 n_from;  ///< geometric normal at `from`; zero for a point light
    Rgb beta;
    Roulette roulette;
    double pdf_fwd = 0;   ///< of the ray's direction; per perpendicular area `from_infinity`
    double pdf_back = 0;  ///< from `from` to its own predecessor
    bool delta = false;
    double radiance_scale = 1;
    MisState mis{};              ///< of the vertex at `from`; unused at the endpoint
    bool from_infinity = false;  ///< from a light there, or an orthographic camera, as if it were there
    Media media{};               ///< through which the ray goes; only where there is absorption
};

namespace {

/// Turns densities per solid angle along the segment from -> to into densities per area at its two ends.
struct SegmentMeasure {
    double to;
    double from;
};

SegmentMeasure measure_segment(const Vec3& from, const Vec3& n_from, const Vec3& to, const Vec3& n_to) {
    return {area_per_solid_angle(from, to, n_to), area_per_solid_angle(to, from, n_from)};
}

}  // namespace

bool SubpathTracer::scatter(Walk& walk, Vertex& vertex, TransportMode mode, Sampler& sampler) const {
    const double u_lobe = sampler.next_1d();
    const Vec2 u = sampler.next_2d();
    const auto sample = vertex.bsdf->sample(vertex.wo, u_lobe, u, mode, context_.settings.adjoint);
    if (!sample) return false;
    walk.beta = vertex.beta * sample->weight;
    if (mode == TransportMode::Radiance) walk.radiance_scale *= sample->radiance_scale;
    walk.from = vertex.si.p;
    walk.n_from = vertex.si.n_g;
    walk.pdf_fwd = sample->pdf_fwd;
    walk.pdf_back = sample->pdf_rev;
    walk.delta = sample->delta;
    walk.mis = vertex.mis;
    walk.from_infinity = false;
    if (absorbs_) walk.media = context_.scene.absorption().beyond(vertex.media, vertex.si, vertex.wo, sample->wi);
    walk.ray = {offset_origin(vertex.si.p, vertex.si.p_error, vertex.si.n_g, sample->wi), sample->wi};
    return true;
}

MisState SubpathTracer::arrive(const Walk& walk, double area_to, double area_back) const {
    return advance(walk.mis, heuristic_, walk.delta, walk.pdf_back, area_back, walk.pdf_fwd * area_to,
                   active_.connection ? 1 : 0);
}

void SubpathTracer::add_vertex(const Walk& walk, const SurfaceInteraction& si, const MisState& mis,
                               std::vector<Vertex>& vertices) const {
    Vertex& vertex = vertices.emplace_back();
    vertex.si = si;
    if (Scene::scatters(si)) vertex.bsdf.emplace(context_.scene.bsdf(si));
    vertex.wo = -walk.ray.direction;
    vertex.beta = walk.beta;
    vertex.mis = mis;
    if (absorbs_) {
        vertex.media = walk.media;
        vertex.beta *= left_of(walk, si.p);
    }
}

Rgb SubpathTracer::left_of(const Walk& walk, const Vec3& p) const {
    return context_.scene.absorption().transmittance(walk.media, length(p - walk.from));
}

// --------------------------------------------------------------------------------------------- light subpaths

std::optional<SubpathTracer::Walk> SubpathTracer::start_light(Sampler& sampler, LightSubpath& path) const {
    const auto choice = context_.scene.light_sampler().sample_emission(draw_light(context_, sampler));
    const Vec2 u_point = sampler.next_2d();
    const Vec2 u_dir = sampler.next_2d();
    if (!choice) return {};
    const Light& light = context_.scene.light(choice->light);
    const EmissionSample emission = context_.scene.emission().sample(light, u_point, u_dir);
    path.start = {choice->light, emission.y, choice->pmf * emission.pdf.pdf_point};
    const Rgb beta = emission.weight / choice->pmf;
    if (is_black(beta)) return {};
    Walk walk{.ray = {offset_origin(emission.origin, emission.y.p_error, light.infinite() ? Vec3{} : emission.y.n,
                                    emission.direction),
                      emission.direction},
              .from = emission.origin,
              .n_from = emission.y.n,
              .beta = beta,
              .roulette = Roulette(context_.settings.roulette_depth, beta)};
    walk.pdf_fwd = emission.pdf.pdf_dir;
    walk.from_infinity = light.infinite();
    walk.media = context_.scene.light_media(choice->light);
    return walk;
}

MisState SubpathTracer::first_light_state(const Walk& walk, const LightStart& start, const Vec3& receiver,
                                          double area_to, double area_back) const {
    const Light& light = context_.scene.light(start.light);
    const double pdf_area = walk.pdf_fwd * area_to;
    const double pdf_direct =
        context_.scene.light_sampler().pmf_direct(receiver, start.light) * light.pdf_direct(receiver, start.y);
    MisState state;
    state.connect = 1 / heuristic_(pdf_area);
    state.adjacent = active_.direct_light ? heuristic_(pdf_direct / start.pdf_point) : 0;
    if (active_.emission_hit && !light.delta()) state.deeper = heuristic_(area_back / (start.pdf_point * pdf_area));
    return state;
}

void SubpathTracer::add_crossing(const Walk& walk, double t_max, LightSubpath& path) const {
    if (!active_.lens_hit) return;
    const bool first = path.vertices.empty();
    const Light& light = context_.scene.light(path.start->light);
    if (first && light.delta()) return;  // a point of light itself is not in the picture
    const auto hit = context_.camera.hit_lens(walk.ray.origin, walk.ray.direction, t_max);
    if (!hit) return;
    SegmentMeasure m = measure_segment(walk.from, walk.n_from, hit->p, context_.camera.forward());
    if (walk.from_infinity) m = {abs_dot(walk.ray.direction, context_.camera.forward()), 1};
    const MisState mis =
        first ? first_light_state(walk, *path.start, hit->p, m.to, m.from) : arrive(walk, m.to, m.from);
    Rgb beta = walk.beta;
    if (absorbs_) beta *= left_of(walk, hit->p);
    path.crossings.push_back({*hit, beta, mis, static_cast<int>(path.vertices.size()) + 2});
}

void SubpathTracer::trace_light(Sampler& sampler, LightSubpath& path, std::uint64_t& rays) const {
    path.clear();
    std::optional<Walk> walk = start_light(sampler, path);
    if (!walk) return;
    const int max_depth = context_.settings.max_depth;
    // At most max_depth surfaces, which are then joined to the lens; one more ray may still find the lens by itself.
    const int last = active_.lens_hit ? max_depth : max_depth - 1;
    for (int depth = 0; depth <= last; ++depth) {
        ++rays;
        const auto si = context_.scene.intersect(walk->ray);
        add_crossing(*walk, si ? length(si->p - walk->ray.origin) : kInfinity, path);
        if (!si || depth >= max_depth || !arrives(walk->from, si->p, si->n_g)) return;
        SegmentMeasure m = measure_segment(walk->from, walk->n_from, si->p, si->n_g);
        if (walk->from_infinity) m = {abs_dot(walk->ray.direction, si->n_g), 1};
        if (!(m.to > 0)) return;  // exactly grazing light from infinity: a set of measure zero
        const MisState mis =
            depth == 0 ? first_light_state(*walk, *path.start, si->p, m.to, m.from) : arrive(*walk, m.to, m.from);
        add_vertex(*walk, *si, mis, path.vertices);
        Vertex& vertex = path.vertices.back();
        if (!vertex.bsdf || !scatter(*walk, vertex, TransportMode::Importance, sampler)) return;
        if (!walk->roulette.survive(depth + 1, 1, walk->beta, sampler)) return;
    }
}

// -------------------------------------------------------------------------------------------- camera subpaths

MisState SubpathTracer::first_camera_state(const CameraRay& ray, double area_to, double area_back) const {
    const double pdf_area = ray.pdf_dir * area_to;
    MisState state;
    state.connect = 1 / heuristic_(pdf_area);
    if (active_.light_image) state.adjacent = heuristic_(active_.light_paths);
    if (active_.lens_hit) {
        state.deeper = heuristic_(active_.light_paths * area_back / (ray.pdf_lens * pdf_area));
    }
    return state;
}

void SubpathTracer::trace_camera(const Vec2& raster, Sampler& sampler, CameraSubpath& path, std::uint64_t& rays) const {
    path.clear();
    const CameraRay first = context_.camera.generate_ray(raster, draw_lens(context_, sampler));
    path.origin = first.origin;
    Walk walk{.ray = {offset_origin(first.origin, {}, {}, first.direction), first.direction},
              .from = first.origin,
              .n_from = context_.camera.forward(),
              .beta = Rgb(first.weight),
              .roulette = Roulette(context_.settings.roulette_depth, Rgb(first.weight)),
              .from_infinity = context_.camera.orthographic(),
              .media = context_.camera_media};
    for (int depth = 0;; ++depth) {
        ++rays;
        const auto si = context_.scene.intersect(walk.ray);
        if (si && !arrives(walk.from, si->p, si->n_g)) return;
        SegmentMeasure m{1, abs_dot(walk.ray.direction, walk.n_from)};  // to infinity
        if (si) m = measure_segment(walk.from, walk.n_from, si->p, si->n_g);
        if (si && walk.from_infinity) m = {abs_dot(walk.ray.direction, si->n_g), 1};
        if (!(m.to > 0)) return;
        MisState mis;
        if (depth > 0) {
            mis = arrive(walk, m.to, m.from);
        } else if (si || !walk.from_infinity) {  // no light sample has the one direction of parallel rays
            mis = first_camera_state(first, m.to, m.from);
        }
        if (!si) {
            if (absorbs_) walk.beta *= context_.scene.absorption().transmittance(walk.media, kInfinity);
            path.escape = {walk.ray.direction, walk.beta, mis, walk.from, depth + 2};
            return;
        }
        add_vertex(walk, *si, mis, path.vertices);
        Vertex& vertex = path.vertices.back();
        if (depth >= context_.settings.max_depth || !vertex.bsdf) return;
        if (!scatter(walk, vertex, TransportMode::Radiance, sampler)) return;
        if (!walk.roulette.survive(depth + 1, walk.radiance_scale, walk.beta, sampler)) return;
    }
}

}  // namespace etendue
