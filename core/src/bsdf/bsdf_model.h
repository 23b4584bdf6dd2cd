#pragma once

#include <variant>

#include "bsdf/conductor.h"
#include "bsdf/dielectric.h"
#include "bsdf/diffuse.h"
#include "bsdf/layered.h"
#include "bsdf/phong.h"
#include "bsdf/rough_diffuse.h"

namespace etendue {

/// The local models. Each works in the shading frame (n_s = +z), knows nothing of n_g, and has
///   Rgb eval(wo, wi, mode, policy)                 f without cosine, non-delta lobes only
///   double pdf(wo, wi)                             per solid angle, non-delta lobes only; the same in both modes
///   optional<BsdfSample> sample(wo, u_lobe, u, mode, policy)
///   bool has_delta() / bool has_non_delta()
using BsdfModel = std::variant<Diffuse, RoughDiffuse, Phong, Conductor, Dielectric, Layered>;

}  // namespace etendue
