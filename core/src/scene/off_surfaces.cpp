#include "scene/off_surfaces.h"

#include <cmath>

namespace etendue {

Vec3 off_surfaces(const Scene& scene, const Vec3& p) {
    const double largest = max_component(abs(p));
    const double reach = (largest + scene.bounds().radius) * 0x1p-18;
    for (const Vec3& w : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {  // one of them is far from grazing
        const auto si = scene.intersect({offset_origin(p - w * reach, {}, {}, w), w});
        if (!si || length(si->p - p) > 2 * reach) continue;
        if (abs_dot(p - si->p, si->n_g) <= 2 * kFloatRounding * largest) {
            return offset_origin(p, si->p_error, si->n_g, si->n_g);
        }
    }
    return p;
}

}  // namespace etendue
