#pragma once

#include "integrator/bdpt/mis.h"
#include "integrator/heuristic.h"

namespace etendue {

/// Weights of the kinds of strategies (theory.md §3), each 1 / (1 + what shorter and longer light subpaths sum up to).
/// Densities are per area except where they are named otherwise; a density of 0 says that a strategy does not exist.

/// The densities by which y0 and the direction that leaves it could have been sampled from the light's side.
struct LightDensities {
    double direct = 0;    ///< y0 by next-event estimation (s = 1, t >= 2)
    double emission = 0;  ///< y0 of a light subpath
    double dir = 0;       ///< of the subpath's first direction, per solid angle; per perpendicular area from infinity
};

/// s = 0: `z` is the state of the vertex on the light. From a lens straight to a light (`first`) the next strategy is
/// (1, 1), which starts at a light subpath's y0; from further on it is next-event estimation.
inline double weight_emission_hit(const Heuristic& h, const MisState& z, const LightDensities& p, bool first,
                                  bool direct_light) {
    const double next = first ? h(p.emission) * z.adjacent : (direct_light ? h(p.direct) : 0);
    return 1 / (1 + next * z.connect + h(p.emission * p.dir) * z.deeper);
}

/// s = 1, t >= 2. `pdf_hit`: of y0 from z; `area_z` turns p.dir into a density per area at z.
inline double weight_direct_light(const Heuristic& h, const MisState& z, const LightDensities& p, double pdf_hit,
                                  double area_z, double pdf_back) {
    return 1 / (1 + h(pdf_hit / p.direct) + h(p.emission / p.direct) * side_sum(z, h, p.dir * area_z, pdf_back));
}

/// s >= 2, t >= 2.
inline double weight_connection(const Heuristic& h, const MisState& y, double pdf_y, double back_y, const MisState& z,
                                double pdf_z, double back_z) {
    return 1 / (1 + side_sum(y, h, pdf_y, back_y) + side_sum(z, h, pdf_z, back_z));
}

/// s >= 2, t = 1, sampled `light_paths` times. `lens_ratio`: density of z0 from y over that of the lens sample.
inline double weight_light_image(const Heuristic& h, const MisState& y, double pdf_y, double back_y, double light_paths,
                                 double lens_ratio) {
    return 1 / (1 + side_sum(y, h, pdf_y, back_y) / h(light_paths) + h(lens_ratio));
}

/// s = 1, t = 1. `hit_ratio`: density of y0 from the lens over that of a light subpath's y0.
inline double weight_light_image_of_start(const Heuristic& h, double hit_ratio, double light_paths, double lens_ratio) {
    return 1 / (1 + h(hit_ratio / light_paths) + h(lens_ratio));
}

/// t = 0: `z` is the state of the light path's vertex on the lens; `pdf_dir` the camera's density per solid angle. The
/// strategy before it is t = 1, where a subpath's first vertex is not chosen anew: z.adjacent does not apply.
inline double weight_lens_hit(const Heuristic& h, const MisState& z, double pdf_lens, double pdf_dir,
                              double light_paths, bool light_image) {
    const double joined = light_image ? z.connect : 0;
    return 1 / (1 + h(pdf_lens) * (joined + h(pdf_dir / light_paths) * z.deeper));
}

}  // namespace etendue
