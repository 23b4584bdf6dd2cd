#pragma once

#include <algorithm>
#include <cmath>

#include "math/vec.h"

namespace etendue {

/// Perimeter of the ellipse cos(t) a + sin(t) b.
[[nodiscard]] inline double ellipse_perimeter(const Vec3& a, const Vec3& b) {
    const double aa = length_squared(a);
    const double bb = length_squared(b);
    // The squares of the semi-axes are the eigenvalues of the Gram matrix; their product is |a cross b|^2.
    const double major2 = (aa + bb + std::hypot(aa - bb, 2 * dot(a, b))) / 2;
    if (major2 == 0) return 0;
    const double minor2 = length_squared(cross(a, b)) / major2;
    const double k2 = std::clamp(1 - minor2 / major2, 0.0, 1.0);
    return 4 * std::sqrt(major2) * std::comp_ellint_2(std::sqrt(k2));
}

}  // namespace etendue
