#include "scene/off_surfaces.h"

#include <algorithm>
#include <cmath>

namespace etendue {

Vec3 off_surfaces(const Scene& scene, const Vec3& p) {
    const double largest = max_component(abs(p));
    // More than rays know a surface to: p_error, along a w that is 55 degrees off its normal. Of flat triangles they
    // know less (plane_roundings.h), but the camera is not moved any farther: it may be under water.
    const double reach = (largest + scene.bounds().radius) * 0x1p-17;
    for (const Vec3& w : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {  // one of them is far from grazing
        const auto si = scene.intersect({offset_origin(p - w * reach, {}, {}, w), w});
        if (!si || length(si->p - p) > 2 * reach) continue;
        const double height = dot(p - si->p, si->n_g);
        const Vec3 error = min(si->p_error, Vec3(reach, reach, reach));
        // A tilted surface is known to what float knows of its corners, however near it lies to the origin.
        const double known_to = std::max(2 * kFloatRounding * largest, dot(abs(si->n_g), error));
        if (std::abs(height) <= known_to) {
            return offset_origin(p - si->n_g * height, error, si->n_g, si->n_g);
        }
    }
    return p;
}

}  // namespace etendue
