#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bsdf/bsdf.h"
#include "math/rng.h"

namespace etendue::test {

inline constexpr AdjointPolicy kCorrect{};

/// Values of f below have few digits or will when multiplied: far from a narrow lobe they are denormal.
inline constexpr double kFewDigits = 1e-290;

/// A model with what a test must know about it.
struct BsdfCase {
    std::string name;
    BsdfModel model;
    double ior = 1;         ///< index inside, seen by directions that cross
    double lobe_width = 1;  ///< radians, of the narrowest lobe that is not a delta
    bool two_sided = true;  ///< the inside behaves like the outside
    bool white = false;     ///< absorbs nothing on purpose: the furnace may lose masked light only
    bool symmetric = true;  ///< physical: reciprocal, and conserves the energy of particles too
};

/// Every model over its parameters: roughness from smooth to 1, indices below, at and above 1, tints, mixtures.
[[nodiscard]] const std::vector<BsdfCase>& bsdf_cases();

/// n_g = n_s = +z: local and world coordinates are the same.
[[nodiscard]] Bsdf flat(const BsdfModel& model);

/// n_g = +z and n_s tilted away from it by some 22 degrees.
[[nodiscard]] Bsdf tilted(const BsdfModel& model);

[[nodiscard]] Vec3 direction(double cos, double phi);

/// Uniform over the sphere.
[[nodiscard]] Vec3 random_direction(Rng& rng);

/// A direction that the BSDF sampled, which puts it where the lobes are; empty for deltas and refusals.
[[nodiscard]] std::optional<Vec3> sample_non_delta(const Bsdf& bsdf, const Vec3& wo, TransportMode mode, Rng& rng);

/// Draws with independent random numbers.
[[nodiscard]] std::optional<BsdfSample> draw(const Bsdf& bsdf, const Vec3& wo, TransportMode mode, Rng& rng,
                                             const AdjointPolicy& policy = kCorrect);

inline double eta_of(const BsdfCase& c, const Vec3& w) { return w.z > 0 ? 1 : c.ior; }

inline constexpr TransportMode kModes[]{TransportMode::Radiance, TransportMode::Importance};

}  // namespace etendue::test
