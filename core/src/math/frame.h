#pragma once

#include <cmath>

#include "math/vec.h"

namespace etendue {

/// Right-handed orthonormal basis; local z is `n`. Names ending in _local are in it, all others in world space.
struct Frame {
    Vec3 s;
    Vec3 t;
    Vec3 n;

    /// Any tangents will do (Duff et al. 2017, branchless and stable at both poles).
    static Frame from_normal(const Vec3& normal) {
        const double sign = std::copysign(1.0, normal.z);
        const double a = -1 / (sign + normal.z);
        const double b = normal.x * normal.y * a;
        return {{1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x},
                {b, sign + normal.y * normal.y * a, -normal.y},
                normal};
    }

    [[nodiscard]] Vec3 to_local(const Vec3& v) const { return {dot(v, s), dot(v, t), dot(v, n)}; }
    [[nodiscard]] Vec3 to_world(const Vec3& v) const { return s * v.x + t * v.y + n * v.z; }
};

/// The direction mirrored at the surface: that far beyond it.
inline Vec3 flip(const Vec3& w_local) { return {w_local.x, w_local.y, -w_local.z}; }

}  // namespace etendue
