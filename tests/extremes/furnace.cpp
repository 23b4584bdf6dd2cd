#include "extremes/furnace.h"

#include "extremes/pictures.h"
#include "support/scene_builder.h"

namespace etendue::test {

LightDesc white_sky() {
    LightDesc sky;
    sky.name = "/sky";
    sky.kind = LightKind::Dome;
    return sky;
}

SceneDescription furnace(const MaterialModel& ball) {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1, b.material(ball));
    b.light(white_sky());
    b.camera({0, 0, 4}, {0, 0, 0}, 19);
    return b.scene();
}

RenderSettings endless(IntegratorKind integrator, int samples_per_pixel) {
    RenderSettings settings = quick_settings(integrator);
    settings.samples_per_pixel = samples_per_pixel;
    settings.max_depth = 1000;
    settings.roulette_depth = -1;
    return settings;
}

}  // namespace etendue::test
