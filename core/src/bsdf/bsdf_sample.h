#pragma once

#include <limits>

#include "math/rgb.h"
#include "math/vec.h"

namespace etendue {

/// A direction whose density is smaller is not sampled: the reciprocal would be infinite.
inline constexpr double kLeastPdf = std::numeric_limits<double>::min();

/// A sampled direction. Of a local model, in the shading frame; of a Bsdf, in world space.
struct BsdfSample {
    Vec3 wi;
    /// f |cos wi| / pdf. For a local model the cosine is to the shading normal, for a Bsdf to the geometric one.
    Rgb weight;
    /// Density of wi given wo, and of wo given wi, per solid angle. Of a delta lobe: its discrete probability P as
    /// P eta_wi^2 |cos wi| and P eta_wo^2 |cos wo|, the densities' ratio under the measure eta^2 dsigma_perp that the
    /// interface preserves (transport.md §1); cosines are to the normal about which the lobe reflects or refracts.
    double pdf_fwd = 0;
    double pdf_rev = 0;
    bool delta = false;
    bool transmission = false;
    /// (eta_wo / eta_wi)^2: divides out of a radiance throughput to leave basic radiance (theory.md §5).
    double radiance_scale = 1;
};

}  // namespace etendue
