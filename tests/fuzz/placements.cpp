#include "fuzz/placements.h"

#include <cmath>

#include "math/constants.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

Matrix4 turned_about(int axis, double angle) {
    const auto i = static_cast<std::size_t>((axis + 1) % 3);
    const auto j = static_cast<std::size_t>((axis + 2) % 3);
    Matrix4 out;
    out.m[i * 4 + i] = out.m[j * 4 + j] = std::cos(angle);
    out.m[i * 4 + j] = -std::sin(angle);
    out.m[j * 4 + i] = std::sin(angle);
    return out;
}

double random_sign(Dice& dice) { return dice.chance(0.5) ? 1 : -1; }

/// Along each axis on its own.
Vec3 extreme_factors(Dice& dice) {
    const auto factor = [&] { return dice.chance(0.3) ? dice.log_between(1e-6, 1e6) : dice.log_between(0.1, 1); };
    const double x = factor();
    const double y = factor();
    return {x, y, factor()};
}

}  // namespace

Matrix4 product(const Matrix4& c_from_b, const Matrix4& b_from_a) {
    Matrix4 out;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            double sum = 0;
            for (std::size_t k = 0; k < 4; ++k) sum += c_from_b.m[i * 4 + k] * b_from_a.m[k * 4 + j];
            out.m[i * 4 + j] = sum;
        }
    }
    return out;
}

Matrix4 scaling(const Vec3& factors) {
    Matrix4 out;
    out.m[0] = factors.x;
    out.m[5] = factors.y;
    out.m[10] = factors.z;
    return out;
}

Matrix4 random_rotation(Dice& dice) {
    const auto angle = [&] { return dice.chance(0.3) ? kPi / 2 * dice.below(4) : dice.between(0.0, 2 * kPi); };
    const Matrix4 x = turned_about(0, angle());
    const Matrix4 y = turned_about(1, angle());
    return product(x, product(y, turned_about(2, angle())));
}

Vec3 random_point(Dice& dice, double reach) {
    const double x = dice.between(-reach, reach);
    const double y = dice.between(-reach, reach);
    return {x, y, dice.between(-reach, reach)};
}

Matrix4 random_placement(Dice& dice) {
    const double size = dice.log_between(0.1, 1.5);
    Vec3 factors{size, size, size};
    if (dice.chance(0.1)) factors = extreme_factors(dice);
    if (dice.chance(0.1)) factors.x *= random_sign(dice);
    if (dice.chance(0.003)) factors.y = 0;
    Matrix4 linear = product(random_rotation(dice), scaling(factors));
    if (dice.chance(0.05)) {
        Matrix4 shear;
        shear.m[1] = random_sign(dice) * dice.log_between(1e-3, 1e3);
        linear = product(shear, linear);
    }
    Matrix4 out = product(translation(random_point(dice, 1)), linear);
    if (dice.hostile()) out.m[static_cast<std::size_t>(dice.below(16))] = dice.number(0.5);
    return out;
}

World random_world(Dice& dice) {
    World world;
    if (dice.chance(0.4)) return world;
    if (dice.chance(0.6)) world.scale = dice.log_between(1e-6, 1e6);
    if (dice.chance(0.02)) world.scale = dice.log_between(1e6, 1e10);
    if (dice.chance(0.5)) world.world_from_studio = random_rotation(dice);
    world.world_from_studio = product(world.world_from_studio, scaling({world.scale, world.scale, world.scale}));
    if (dice.chance(0.6)) {
        const double reach = world.scale * dice.log_between(1, 1e6);
        world.world_from_studio = product(translation(random_point(dice, reach)), world.world_from_studio);
    }
    return world;
}

}  // namespace etendue::test
