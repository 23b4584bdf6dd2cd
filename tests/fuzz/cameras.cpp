#include "fuzz/cameras.h"

#include "fuzz/placements.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

Vec3 random_position(Dice& dice) {
    const double which = dice.unit();
    if (which < 0.6) return normalize(random_point(dice, 1) + Vec3{0, 0, 1e-3}) * 4;
    if (which < 0.85) return random_point(dice, 1);
    // Where floors, walls and the surfaces of unit bodies are.
    return {dice.one_of({0.0, 1.0, -1.0}), dice.one_of({0.0, 1.0, -1.0, 1e-6}), dice.one_of({0.5, 1.0, 1e-6})};
}

}  // namespace

CameraDesc random_camera(Dice& dice, double scale) {
    CameraDesc camera;
    camera.world_from_camera = look_at(random_position(dice), random_point(dice, 0.5));
    if (dice.chance(0.15)) camera.projection = CameraProjection::Orthographic;
    const double unit = camera.projection == CameraProjection::Orthographic ? 4 * scale : 1;
    camera.horizontal_aperture = dice.number(unit * 10);
    camera.vertical_aperture = dice.number(unit * 10);
    camera.focal_length = dice.number(dice.chance(0.15) ? dice.log_between(1e-3, 1e6) : dice.between(8, 30));
    if (dice.chance(0.1)) camera.horizontal_aperture_offset = dice.number(unit * dice.between(-20, 20));
    if (dice.chance(0.1)) camera.vertical_aperture_offset = dice.number(unit * dice.between(-20, 20));
    if (dice.chance(0.3)) {
        const double lens = dice.chance(0.3) ? dice.log_between(1e-6, 1e3) : 0.1;
        camera.f_stop = dice.number(camera.focal_length / (20 * lens * scale));
        camera.focus_distance = dice.number(scale * (dice.chance(0.3) ? dice.log_between(1e-6, 1e6) : 4));
    }
    if (dice.chance(0.1)) camera.exposure_scale = dice.one_of({0.0, 1e-20, 1e-3, 1e6});
    camera.exposure_scale = dice.number(camera.exposure_scale);
    return camera;
}

}  // namespace etendue::test
