#include "support/path_oracle.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/sampling.h"

namespace etendue::test {
namespace {

/// Any vertex: where it is, which area density belongs to it.
struct Node {
    Vec3 p;  ///< a direction when infinite
    Vec3 n;
    bool infinite = false;
};

Vec3 direction(const Node& from, const Node& to) {
    if (to.infinite) return to.p;
    if (from.infinite) return -from.p;
    return normalize(to.p - from.p);
}

/// Density per area (per solid angle at infinity) of `to`, from a density per solid angle at `from`; from infinity the
/// density is per perpendicular area.
double to_area(const Node& from, const Node& to, double pdf) {
    if (to.infinite) return pdf;
    const double cos = std::abs(dot(direction(from, to), to.n));
    if (from.infinite) return pdf * cos;
    return pdf * cos / length_squared(to.p - from.p);
}

/// P eta^2 |cos| of the delta lobe that sends wo nearest to wi, found by trying the lobes.
double delta_density(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi) {
    constexpr int kTries = 1000;
    double nearest = 0.01;
    double density = std::nan("");
    for (int i = 0; i <= kTries; ++i) {
        const double u = std::min(static_cast<double>(i) / kTries, kOneMinusEpsilon);
        const auto sample = bsdf.sample(wo, u, {0.5, 0.5}, TransportMode::Radiance, {});
        if (!sample || !sample->delta || length(sample->wi - wi) >= nearest) continue;
        nearest = length(sample->wi - wi);
        density = sample->pdf_fwd;
    }
    return density;
}

double scatter_density(const PathVertex& vertex, const Vec3& wo, const Vec3& wi) {
    return vertex.delta ? delta_density(*vertex.bsdf, wo, wi) : vertex.bsdf->pdf(wo, wi);
}

}  // namespace

PathDensities path_densities(const WholePath& path, const RenderContext& context) {
    const Light& light = context.scene.light(path.light);
    std::vector<Node> nodes{{path.y.p, path.y.n, light.infinite()}};
    for (const PathVertex& v : path.surfaces) nodes.push_back({v.p, v.n_g});
    const bool parallel = context.camera.orthographic();
    const Vec3& forward = context.camera.forward();
    nodes.push_back({parallel ? -forward : path.lens, forward, parallel});  // as if it were at infinity
    const std::size_t k = nodes.size() - 1;

    PathDensities d;
    d.light.resize(k + 1);
    d.camera.resize(k + 1);
    d.delta.resize(k + 1);
    d.light_is_delta = light.delta();
    d.has_lens = context.camera.has_lens();

    const EmissionPdf emission = context.scene.emission().pdf(light, path.y, direction(nodes[0], nodes[1]), nodes[1].p);
    d.light[0] = context.scene.light_sampler().pmf_emission(path.light) * emission.pdf_point;
    d.direct = context.scene.light_sampler().pmf_direct(nodes[1].p, path.light) * light.pdf_direct(nodes[1].p, path.y);
    d.light[1] = to_area(nodes[0], nodes[1], emission.pdf_dir);

    const Vec3 ray = direction(nodes[k], nodes[k - 1]);
    d.camera[k] = context.camera.generate_ray({}, {}).pdf_lens;
    d.camera[k - 1] = to_area(nodes[k], nodes[k - 1], context.camera.pdf_dir(path.lens, ray));
    d.one_direction = parallel && nodes[k - 1].infinite;

    for (std::size_t i = 1; i < k; ++i) {
        const PathVertex& v = path.surfaces[i - 1];
        const Vec3 to_light = direction(nodes[i], nodes[i - 1]);
        const Vec3 to_lens = direction(nodes[i], nodes[i + 1]);
        d.delta[i] = v.delta;
        d.light[i + 1] = to_area(nodes[i], nodes[i + 1], scatter_density(v, to_light, to_lens));
        d.camera[i - 1] = to_area(nodes[i], nodes[i - 1], scatter_density(v, to_lens, to_light));
    }
    return d;
}

}  // namespace etendue::test
