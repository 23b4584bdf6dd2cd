#pragma once

#include <etendue/scene_description.h>

#include "math/frame.h"
#include "math/rng.h"
#include "math/sampling.h"
#include "math/vec.h"

namespace etendue::test {

inline Vec3 random_direction(Rng& rng) { return sample_uniform_sphere(rng.next_2d()); }

/// In the cube of half-width `half` about the origin.
inline Vec3 random_point(Rng& rng, double half) {
    const double x = rng.next_1d();
    const double y = rng.next_1d();
    return Vec3{2 * x - 1, 2 * y - 1, 2 * rng.next_1d() - 1} * half;
}

/// The map whose columns are x, y and z, and its translation.
inline Matrix4 from_columns(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& t) {
    return {{x.x, y.x, z.x, t.x, x.y, y.y, z.y, t.y, x.z, y.z, z.z, t.z, 0, 0, 0, 1}};
}

inline Matrix4 scaling(double x, double y, double z, const Vec3& t = {}) {
    return from_columns({x, 0, 0}, {0, y, 0}, {0, 0, z}, t);
}

/// Turned, stretched by factors in [1/2, 2] and sheared, times `scale`, then moved by `t`.
inline Matrix4 random_affine(Rng& rng, double scale, const Vec3& t, bool mirrored) {
    const Frame turn = Frame::from_normal(random_direction(rng));
    const Frame stretch = Frame::from_normal(random_direction(rng));
    const Vec3 factors{0.5 + 1.5 * rng.next_1d(), 0.5 + 1.5 * rng.next_1d(), 0.5 + 1.5 * rng.next_1d()};
    const auto column = [&](const Vec3& axis) {
        const Vec3 l = stretch.to_local(axis);
        const Vec3 stretched = stretch.to_world({l.x * factors.x, l.y * factors.y, l.z * factors.z});
        return turn.to_world(stretched) * scale;
    };
    return from_columns(column({mirrored ? -1.0 : 1.0, 0, 0}), column({0, 1, 0}), column({0, 0, 1}), t);
}

}  // namespace etendue::test
