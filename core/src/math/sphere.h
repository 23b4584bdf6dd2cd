#pragma once

#include <cmath>

#include "math/vec.h"

namespace etendue {

struct Sphere {
    Vec3 center;
    double radius = 0;
};

/// The smallest around both.
inline Sphere enclose(const Sphere& a, const Sphere& b) {
    const Vec3 d = b.center - a.center;
    const double distance = length(d);
    if (distance + b.radius <= a.radius) return a;
    if (distance + a.radius <= b.radius) return b;
    const double radius = (a.radius + distance + b.radius) / 2;
    return {a.center + d * ((radius - a.radius) / distance), radius};
}

}  // namespace etendue
