#pragma once

#include <cmath>

#include <etendue/render_settings.h>

#include "bsdf/transport_mode.h"
#include "math/vec.h"

namespace etendue {

/// The three asymmetries of scattering, and nowhere else (theory.md §5, §6, §7; Veach 5.2, 5.3).

/// Factor on the weight of a path that crosses a refracting interface. Radiance is scaled by the squared index of the
/// known (camera) side over the sampled one; particles are not scaled. With the correction off, particles are scaled
/// like radiance along the light's flow, (eta_t / eta_i)^2, which is wrong.
///
/// That is radiance per unit frequency, which refraction does not change, or per unit VACUUM wavelength, and what the
/// renderer's colours are made of. Per unit wavelength in the medium, lambda / eta, a band narrows by eta as well and
/// the factor is (eta_t / eta_i)^3; under dispersion each side has 1 - d ln eta / d ln lambda in its denominator
/// besides. No colour measured in vacuum needs that: leaving the body divides by it again.
inline double squared_index_factor(TransportMode mode, double eta_known, double eta_sampled,
                                   const AdjointPolicy& policy) {
    if (mode == TransportMode::Radiance) {
        const double ratio = eta_known / eta_sampled;
        return ratio * ratio;
    }
    if (policy.refraction) return 1;
    const double ratio = eta_sampled / eta_known;
    return ratio * ratio;
}

/// What turns f |wi . n_s| (a BSDF that knows n_s only) into fbar |wi . n_g| for the given transport mode. Radiance:
/// the factor cancels. Particles: |wo . n_s| |wi . n_g| / (|wo . n_g| |wi . n_s|), left out when the correction is off.
/// The four arguments are absolute cosines.
inline double shading_normal_factor(TransportMode mode, double cos_wo_ng, double cos_wo_ns, double cos_wi_ng,
                                    double cos_wi_ns, const AdjointPolicy& policy) {
    if (mode == TransportMode::Radiance || !policy.shading_normal) return 1;
    return (cos_wo_ns * cos_wi_ng) / (cos_wo_ng * cos_wi_ns);
}

/// The cosine by which the classic Phong form divides: that of the direction light comes from, which is the sampled one
/// for radiance and the known one for particles. With the correction off, particles are scattered as if they were
/// radiance: wrong / right = |wi . N| / |wo . N| with wi where light comes from. Absolute cosines, local names.
inline double phong_cosine(TransportMode mode, double cos_wo, double cos_wi, const AdjointPolicy& policy) {
    return mode == TransportMode::Radiance || !policy.phong ? cos_wi : cos_wo;
}

}  // namespace etendue
