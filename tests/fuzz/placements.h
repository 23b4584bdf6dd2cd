#pragma once

#include <etendue/scene_description.h>

#include "fuzz/dice.h"
#include "math/vec.h"

namespace etendue::test {

[[nodiscard]] Matrix4 product(const Matrix4& c_from_b, const Matrix4& b_from_a);
[[nodiscard]] Matrix4 scaling(const Vec3& factors);
[[nodiscard]] Matrix4 random_rotation(Dice& dice);
[[nodiscard]] Vec3 random_point(Dice& dice, double reach);

/// Where an object of size 1 goes: some place near the origin, or scaled by 1e-6 to 1e6 along each axis, sheared,
/// mirrored, rarely singular.
[[nodiscard]] Matrix4 random_placement(Dice& dice);

/// Where the whole scene goes.
struct World {
    Matrix4 world_from_studio;
    double scale = 1;
};
/// Often the identity; else scaled by 1e-6 to 1e6 (rarely 1e10), turned, and up to 1e6 units off the origin.
[[nodiscard]] World random_world(Dice& dice);

}  // namespace etendue::test
