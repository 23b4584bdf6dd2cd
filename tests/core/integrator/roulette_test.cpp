// Russian roulette ends paths; it must not change the picture (transport.md §4), least of all where throughput and what
// a path can still carry differ: inside glass, where radiance is scaled, and where little is absorbed.

#include <string>

#include <gtest/gtest.h>

#include "integrator/roulette.h"
#include "support/invalid_operations.h"
#include "support/replicas.h"
#include "support/scene_builder.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

SceneDescription bright_box() {
    SceneDescription scene = diffuse_box();
    for (MaterialDesc& material : scene.materials) material.model = DiffuseMaterial{{{0.9, 0.9, 0.9}}};
    return scene;
}

/// The camera in a frosted body, whose index is high enough for its scale, 1/eta^2, to matter.
SceneDescription inside_glass() {
    SceneBuilder b;
    DielectricMaterial glass;
    glass.ior = 2;
    glass.roughness.value = 0.6;
    b.sphere({0, 0, 0}, 1, b.material(glass));
    b.quad({-1, -1.1, 1}, {2, 0, 0}, {0, 0, -2}, b.diffuse(0.8));
    LightDesc dome;
    dome.kind = LightKind::Dome;
    b.light(dome);
    b.camera({0, 0, 0.4}, {0, -0.3, 0}, 70);
    return b.scene();
}

/// A camera whose exposure is 0 carries nothing from the start.
TEST(Roulette, EndsWhatStartsWithNothing) {
    const Roulette roulette(0, Rgb(0));
    Rgb throughput(0);
    Sampler sampler(SampleIndex{});
    bool survives = true;
    EXPECT_FALSE(raises_invalid([&] { survives = roulette.survive(1, 1, throughput, sampler); }));
    EXPECT_FALSE(survives);
}

struct Case {
    const char* name;
    SceneDescription (*scene)();
    IntegratorKind integrator;
    int samples_per_pixel = 128;
    double resolution = 0.008;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class RussianRoulette : public testing::TestWithParam<Case> {};

TEST_P(RussianRoulette, ChangesNothing) {
    const SceneDescription scene = GetParam().scene();
    RenderSettings settings = small_settings(GetParam().integrator, 8, GetParam().samples_per_pixel);
    settings.max_depth = 10;
    settings.roulette_depth = -1;
    const Replicas never = render_replicas(scene, settings, 20, 1).blocks(4);  // few particles find a single pixel
    std::uint64_t stream = 2;
    for (int depth : {0, 2, 5}) {
        SCOPED_TRACE(depth);
        settings.roulette_depth = depth;
        const Replicas sometimes = render_replicas(scene, settings, 20, stream++).blocks(4);
        EXPECT_TRUE(same_picture(never, sometimes, GetParam().resolution));
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, RussianRoulette,
                         testing::Values(Case{"bright_path", bright_box, IntegratorKind::Path},
                                         Case{"bright_light", bright_box, IntegratorKind::Light},
                                         Case{"bright_bdpt", bright_box, IntegratorKind::Bdpt},
                                         Case{"glass_path", inside_glass, IntegratorKind::Path},
                                         Case{"glass_light", inside_glass, IntegratorKind::Light, 1000, 0.02},
                                         Case{"glass_bdpt", inside_glass, IntegratorKind::Bdpt},
                                         Case{"caustic_bdpt", glass_box, IntegratorKind::Bdpt}),
                         [](const auto& test) { return std::string(test.param.name); });

/// Paths in a body that absorbs nothing end only by roulette, and the camera sees the same light with and without.
TEST(RussianRouletteInGlass, KeepsBasicRadiance) {
    SceneBuilder b;
    DielectricMaterial glass;
    glass.ior = 2;
    b.sphere({0, 0, 0}, 1, b.material(glass));
    LightDesc dome;
    dome.kind = LightKind::Dome;
    b.light(dome);
    b.camera({0, 0, 0}, {0, 0, -1}, 60);  // from the centre nothing is trapped
    for (IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
        RenderSettings settings = small_settings(integrator, 8, 32);
        settings.max_depth = 200;
        settings.roulette_depth = 1;
        EXPECT_TRUE(mean_is(render_replicas(b.scene(), settings, 16, 1), 4, 0.003));
    }
}

}  // namespace
}  // namespace etendue::test
