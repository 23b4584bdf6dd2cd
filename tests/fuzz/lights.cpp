#include "fuzz/lights.h"

#include "fuzz/materials.h"
#include "fuzz/placements.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

double random_size(Dice& dice) {
    if (dice.chance(0.02)) return 0;
    return dice.number(dice.chance(0.3) ? dice.log_between(1e-6, 1e3) : dice.log_between(0.05, 2));
}

double random_angle(Dice& dice, double most) {
    return dice.number(dice.chance(0.5) ? dice.between(0.0, most)
                                        : dice.one_of({0.0, 1e-20, 1e-6, most / 2, most, 2 * most}));
}

ShapingDesc random_shaping(Dice& dice) {
    ShapingDesc shaping;
    if (dice.chance(0.5)) shaping.focus = dice.number(dice.one_of({1e-20, 1.0, 5.0, 100.0, 1e6, 1e20}));
    if (dice.chance(0.3)) shaping.focus_tint = random_color(dice);
    shaping.cone_angle = random_angle(dice, 180);
    if (dice.chance(0.5)) shaping.cone_softness = dice.fraction();
    return shaping;
}

LightDesc random_emission(Dice& dice) {
    LightDesc light;
    light.intensity = dice.power(1);
    if (dice.chance(0.2)) light.exposure = dice.number(dice.between(-20, 20));
    if (dice.chance(0.4)) light.color = random_color(dice);
    if (dice.chance(0.1)) light.color_temperature_rgb = random_color(dice);
    light.normalize = dice.chance(0.5);
    return light;
}

}  // namespace

LightDesc random_light(Dice& dice, const std::string& texture_file) {
    LightDesc light = random_emission(dice);
    light.kind = dice.one_of({LightKind::Rect, LightKind::Disk, LightKind::Sphere, LightKind::Cylinder,
                              LightKind::Distant, LightKind::Dome});
    light.width = random_size(dice);
    light.height = random_size(dice);
    light.length = random_size(dice);
    light.radius = random_size(dice);
    light.treat_as_point = dice.chance(0.15);
    light.treat_as_line = dice.chance(0.15);
    light.angle = random_angle(dice, 180);
    if (dice.chance(0.3)) light.texture_file = texture_file;
    light.pole_axis = dice.one_of({Axis::Y, Axis::Z});
    if (dice.chance(0.25)) light.shaping = random_shaping(dice);
    if (dice.chance(0.15)) {
        light.world_from_light = random_placement(dice);
    } else {
        const Vec3 from = normalize(random_point(dice, 1) + Vec3{0, 1.5, 0}) * dice.log_between(0.5, 4);
        light.world_from_light = look_at(from, random_point(dice, 0.3));
    }
    return light;
}

LightDesc random_mesh_light(Dice& dice, int shape) {
    LightDesc light = random_emission(dice);
    light.kind = LightKind::Mesh;
    light.shape = shape;
    light.tinted_by_material = dice.chance(0.4);
    if (dice.chance(0.2)) light.shaping = random_shaping(dice);
    return light;
}

}  // namespace etendue::test
