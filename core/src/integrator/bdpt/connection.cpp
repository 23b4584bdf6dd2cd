#include "integrator/bdpt/connection.h"

#include <cmath>

#include "integrator/needed_draws.h"
#include "math/measure.h"

namespace etendue {

LightDensities Connector::light_densities(int light_index, const LightPoint& y, const Vec3& receiver,
                                          const Vec3& w) const {
    const Light& light = context_.scene.light(light_index);
    const LightSampler& sampler = context_.scene.light_sampler();
    const EmissionPdf pdf = context_.scene.emission().pdf(light, y, w, receiver);
    return {sampler.pmf_direct(receiver, light_index) * light.pdf_direct(receiver, y),
            sampler.pmf_emission(light_index) * pdf.pdf_point, pdf.pdf_dir};
}

void Connector::absorb_from(const Vertex& v, const Vec3& w, double distance, Rgb& value) const {
    const Absorption& absorption = context_.scene.absorption();
    value *= absorption.transmittance(absorption.beyond(v.media, v.si, v.wo, w), distance);
}

// ------------------------------------------------------------------------------------------------------- s = 0

std::optional<Contribution> Connector::emission(const CameraSubpath& camera, std::size_t i) const {
    const Vertex& z = camera.vertices[i];
    if (z.si.light < 0) return {};
    const LightPoint y{z.si.p, z.si.n_g, z.si.st, z.si.p_error};
    const Rgb radiance = context_.scene.light(z.si.light).radiance(y, z.wo);
    if (is_black(radiance)) return {};
    const Vec3& receiver = i == 0 ? camera.origin : camera.vertices[i - 1].si.p;
    const LightDensities p = light_densities(z.si.light, y, receiver, z.wo);
    return Contribution{z.beta * radiance, weight_emission_hit(heuristic_, z.mis, p, i == 0, active_.direct_light), {}};
}

std::optional<Contribution> Connector::infinite_emission(const Escape& escape, int light_index) const {
    const LightPoint y{escape.direction, -escape.direction, {}, {}};
    const Rgb radiance = context_.scene.light(light_index).radiance(y, -escape.direction);
    if (is_black(radiance)) return {};
    const LightDensities p = light_densities(light_index, y, escape.from, -escape.direction);
    return Contribution{escape.beta * radiance,
                        weight_emission_hit(heuristic_, escape.mis, p, escape.t == 2, active_.direct_light),
                        {}};
}

// ------------------------------------------------------------------------------------------------------- s = 1

std::optional<Contribution> Connector::direct(const Vertex& z, Sampler& sampler, std::uint64_t& rays) const {
    const auto choice = context_.scene.light_sampler().sample_direct(z.si.p, draw_light(context_, sampler));
    const Vec2 u = sampler.next_2d();
    if (!choice) return {};
    const Light& light = context_.scene.light(choice->light);
    const auto sample = light.sample_direct(z.si.p, u);
    if (!sample) return {};
    const Vec3& wi = sample->wi;
    const Rgb f = z.bsdf->eval_cos(z.wo, wi, TransportMode::Radiance, context_.settings.adjoint);
    Contribution c{z.beta * f * sample->weight / choice->pmf, 0, {}};
    if (absorbs_) absorb_from(z, wi, sample->distance, c.value);
    if (is_black(c.value)) return {};

    LightDensities p = light_densities(choice->light, sample->y, z.si.p, -wi);
    p.direct = choice->pmf * sample->pdf_point;
    const bool infinite = light.infinite();
    double pdf_hit = 0;
    if (active_.emission_hit && !light.delta()) {
        const double area_y = infinite ? 1 : area_per_solid_angle(z.si.p, sample->y.p, sample->y.n);
        pdf_hit = z.bsdf->pdf(z.wo, wi) * area_y;
    }
    const double area_z = infinite ? abs_dot(wi, z.si.n_g) : area_per_solid_angle(sample->y.p, z.si.p, z.si.n_g);
    c.weight = weight_direct_light(heuristic_, z.mis, p, pdf_hit, area_z, z.bsdf->pdf(wi, z.wo));

    ++rays;
    const RayEnd here = RayEnd::on(z.si);
    const bool open =
        infinite ? context_.scene.sees_infinity(here, wi) : context_.scene.visible(here, RayEnd::on(sample->y));
    if (!open) return {};
    return c;
}

// --------------------------------------------------------------------------------------------- s >= 2, t >= 2

std::optional<Contribution> Connector::connect(const Vertex& y, const Vertex& z, std::uint64_t& rays) const {
    const Vec3 d = z.si.p - y.si.p;
    const double d2 = length_squared(d);
    if (!(d2 > 0)) return {};
    const Vec3 w = d / std::sqrt(d2);
    const AdjointPolicy& policy = context_.settings.adjoint;
    const Rgb f_y = y.bsdf->eval_cos(y.wo, w, TransportMode::Importance, policy);
    if (is_black(f_y)) return {};
    const Rgb f_z = z.bsdf->eval_cos(z.wo, -w, TransportMode::Radiance, policy);
    Contribution c{y.beta * f_y * f_z * z.beta / d2, 0, {}};
    if (absorbs_) absorb_from(y, w, std::sqrt(d2), c.value);
    if (is_black(c.value)) return {};

    const double pdf_z = y.bsdf->pdf(y.wo, w) * area_per_solid_angle(y.si.p, z.si.p, z.si.n_g);
    const double pdf_y = z.bsdf->pdf(z.wo, -w) * area_per_solid_angle(z.si.p, y.si.p, y.si.n_g);
    c.weight = weight_connection(heuristic_, y.mis, pdf_y, y.bsdf->pdf(w, y.wo), z.mis, pdf_z, z.bsdf->pdf(-w, z.wo));

    ++rays;
    if (!context_.scene.visible(RayEnd::on(y.si), RayEnd::on(z.si))) return {};
    return c;
}

// ------------------------------------------------------------------------------------------------------ t <= 1

bool Connector::on_film(const Vec2& raster) const {
    const double r = context_.filter.radius() - 0.5;  // how far beyond its own square a pixel gathers
    const PixelWindow& window = context_.window;
    return raster.x >= window.x0 - r && raster.x < window.x1 + r && raster.y >= window.y0 - r &&
           raster.y < window.y1 + r;
}

double Connector::lens_ratio(double pdf_to_lens, const LensSample& lens) const {
    if (!active_.lens_hit) return 0;
    const double cos_lens = abs_dot(lens.direction, context_.camera.forward());
    const double area = std::isinf(lens.distance) ? cos_lens : cos_lens / (lens.distance * lens.distance);
    return pdf_to_lens * area / lens.pdf_lens;
}

double Connector::area_from_lens(const LensSample& lens, const Vec3& p, const Vec3& n_g) const {
    return context_.camera.orthographic() ? abs_dot(lens.direction, n_g) : area_per_solid_angle(lens.origin, p, n_g);
}

std::optional<Contribution> Connector::to_lens(const Vertex& y, Sampler& sampler, std::uint64_t& rays) const {
    const auto lens = context_.camera.sample_lens(y.si.p, draw_lens(context_, sampler));
    if (!lens || !on_film(lens->raster)) return {};
    const Vec3 w = -lens->direction;
    const Rgb f = y.bsdf->eval_cos(y.wo, w, TransportMode::Importance, context_.settings.adjoint);
    Contribution c{y.beta * f * lens->weight, 0, lens->raster};
    if (absorbs_) absorb_from(y, w, lens->distance, c.value);
    if (is_black(c.value)) return {};

    const double pdf_y = lens->pdf_dir * area_from_lens(*lens, y.si.p, y.si.n_g);
    c.weight = weight_light_image(heuristic_, y.mis, pdf_y, y.bsdf->pdf(w, y.wo), active_.light_paths,
                                  lens_ratio(y.bsdf->pdf(y.wo, w), *lens));

    ++rays;
    if (!context_.scene.visible(RayEnd::on(y.si), RayEnd::free(lens->origin))) return {};
    return c;
}

std::optional<Contribution> Connector::start_to_lens(const LightStart& start, Sampler& sampler,
                                                     std::uint64_t& rays) const {
    const Light& light = context_.scene.light(start.light);
    const Vec2 u_lens = draw_lens(context_, sampler);
    if (light.delta()) return {};  // a point of light itself is not in the picture
    const bool infinite = light.infinite();
    const auto lens = infinite ? context_.camera.sample_lens_towards(start.y.p, u_lens)
                               : context_.camera.sample_lens(start.y.p, u_lens);
    if (!lens || !on_film(lens->raster)) return {};
    const Vec3 w = -lens->direction;
    const double cos_y = infinite ? 1 : abs_dot(w, start.y.n);
    Contribution c{light.radiance(start.y, w) * (cos_y * lens->weight / start.pdf_point), 0, lens->raster};
    if (absorbs_) {
        const Media media = infinite ? context_.camera_media : context_.scene.light_media(start.light);
        c.value *= context_.scene.absorption().transmittance(media, lens->distance);
    }
    if (is_black(c.value)) return {};

    const double area_y = infinite ? 1 : area_from_lens(*lens, start.y.p, start.y.n);
    const double hit_ratio = active_.emission_hit ? lens->pdf_dir * area_y / start.pdf_point : 0;
    const double pdf_dir = context_.scene.emission().pdf(light, start.y, w, lens->origin).pdf_dir;
    c.weight = weight_light_image_of_start(heuristic_, hit_ratio, active_.light_paths, lens_ratio(pdf_dir, *lens));

    ++rays;
    const bool open = infinite ? context_.scene.sees_infinity(RayEnd::free(lens->origin), lens->direction)
                               : context_.scene.visible(RayEnd::on(start.y), RayEnd::free(lens->origin));
    if (!open) return {};
    return c;
}

std::optional<Contribution> Connector::lens_hit(const LensCrossing& crossing) const {
    const LensHit& hit = crossing.hit;
    // Light finds a wide lens from where no pixel looks: off the picture by more pixels than an int can count.
    if (!on_film(hit.raster)) return {};
    Contribution c{crossing.beta * hit.importance, 0, hit.raster};
    c.weight =
        weight_lens_hit(heuristic_, crossing.mis, hit.pdf_lens, hit.pdf_dir, active_.light_paths, active_.light_image);
    return c;
}

}  // namespace etendue
