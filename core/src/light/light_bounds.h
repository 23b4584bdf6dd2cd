#pragma once

#include "math/vec.h"

namespace etendue {

/// Where a light is and whither it shines, never less than that (Conty Estevez and Kulla 2018): a box that holds its
/// points, a cone that holds its normals, and how far from its normal a point emits.
struct LightBounds {
    Vec3 lower;
    Vec3 upper;
    Vec3 axis{0, 0, 1};       ///< of the cone of normals, unit
    double cos_normals = -1;  ///< its half angle; -1: normals, or a point's directions, all around
    double cos_emission = 0;  ///< light leaves within this angle of the normal, a right angle at most; of a narrow
                              ///< beam's axis, which then counts as the only normal

    [[nodiscard]] Vec3 center() const { return (lower + upper) * 0.5; }
    [[nodiscard]] double diagonal_squared() const { return length_squared(upper - lower); }

    /// Flux over the greatest intensity, steradians: pi for what is flat and diffuse, 4 pi for what shines all around.
    [[nodiscard]] double emission_measure() const;
};

/// The least bounds of that form around both, as far as cones allow.
[[nodiscard]] LightBounds enclose(const LightBounds& a, const LightBounds& b);

}  // namespace etendue
