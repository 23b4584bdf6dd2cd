#pragma once

#include "integrator/heuristic.h"

namespace etendue {

/// Weights of bidirectional strategies in O(1): pure arithmetic on densities, the same for both kinds of subpath.
///
/// Strategies of one path are compared by ratios p_{i+1}/p_i = P_light(x_i) / P_camera(x_i) (theory.md §3). Seen from
/// the end vertex v of a subpath, the strategies that leave this subpath shorter sum up to
///
///     h(P_other(v)) * ( adjacent * connect + h(pdf_back) * deeper )
///
/// where P_other(v) is the density per area with which the other side would have sampled v, pdf_back the density per
/// solid angle of going on from v to its predecessor, and h(x) = x^beta. Once v is left for a next vertex, both are
/// known and fold into that vertex's state. Double holds the squares at any scene scale: each state is divided by its
/// own density, so nothing accumulates along the path.
struct MisState {
    /// 1 / h(P(v)), or 0 when v was reached through a delta lobe: no connection of its predecessor to v.
    double connect = 0;
    /// Factor of that strategy alone: whether it takes part, its number of samples, and its own density of the first
    /// vertex relative to the subpath's.
    double adjacent = 0;
    /// All shorter strategies, up to h(pdf_back).
    double deeper = 0;
};

/// State of the vertex reached from `from` by a bounce. `pdf_back` belongs to `from` (towards its own predecessor) and
/// `area_back` turns densities at the new vertex into densities per area at `from`; `pdf_area` is the density per area
/// of the new vertex. For a delta bounce pdf_back and pdf_area are made of BsdfSample's discrete densities.
inline MisState advance(const MisState& from, const Heuristic& h, bool delta, double pdf_back, double area_back,
                        double pdf_area, double adjacent) {
    const double fold = (delta ? 0 : from.adjacent * from.connect) + h(pdf_back) * from.deeper;
    return {delta ? 0 : 1 / h(pdf_area), adjacent, h(area_back / pdf_area) * fold};
}

/// The sum above.
inline double side_sum(const MisState& state, const Heuristic& h, double pdf_other, double pdf_back) {
    return h(pdf_other) * (state.adjacent * state.connect + h(pdf_back) * state.deeper);
}

}  // namespace etendue
