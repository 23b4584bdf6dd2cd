#pragma once

#include <cmath>
#include <limits>

#include "math/constants.h"
#include "math/vec.h"

namespace etendue {

struct Ray {
    Vec3 origin;
    Vec3 direction;  ///< unit for rays that seek; from end to end for visibility rays
};

/// Half a unit in the last place of float, relative: the rounding error of one float operation.
inline constexpr double kFloatRounding = 0x1p-24;

/// No coordinate may be larger: Embree takes none beyond 1.8e18, half the root of float's range, and may end the
/// process when it meets one.
inline constexpr double kFarthest = 1e18;

/// False for NaN.
inline bool within_reach(const Vec3& p) { return max_component(abs(p)) <= kFarthest; }

namespace detail {
/// `value` as a float, rounded in the direction of `towards` (a sign; 0: nearest).
inline double round_to_float(double value, double towards) {
    auto f = static_cast<float>(value);
    if (towards > 0 && static_cast<double>(f) < value) f = std::nextafter(f, std::numeric_limits<float>::infinity());
    if (towards < 0 && static_cast<double>(f) > value) f = std::nextafter(f, -std::numeric_limits<float>::infinity());
    return static_cast<double>(f);
}
}  // namespace detail

/// Start of a ray that leaves the surface at p along w: moved off the surface by the position's own error bound, so
/// that it holds at any scale, and already a float triple, as Embree will see it.
inline Vec3 offset_origin(const Vec3& p, const Vec3& p_error, const Vec3& n_g, const Vec3& w) {
    const double distance = dot(abs(n_g), p_error);
    const Vec3 shift = n_g * (dot(w, n_g) < 0 ? -distance : distance);
    return {detail::round_to_float(p.x + shift.x, shift.x), detail::round_to_float(p.y + shift.y, shift.y),
            detail::round_to_float(p.z + shift.z, shift.z)};
}

}  // namespace etendue
