// Closed furnaces that absorb nothing: light bounces for ever, and every bounce must keep all of it.

#include <algorithm>
#include <cmath>

#include "extremes/agreement.h"
#include "extremes/extreme.h"
#include "extremes/furnace.h"
#include "extremes/pictures.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

constexpr int kDepth = 1000;

/// The inside of a ball that glows and reflects: radiance e (1 + a + a^2 + ... + a^depth).
SceneDescription glowing_ball(double albedo, double emission) {
    SceneBuilder b;
    MeshDesc ball = low_polygon_sphere(12, 8, false);
    ball.left_handed = true;  // it glows inwards
    b.shape(ball, b.material(DiffuseMaterial{{{albedo, albedo, albedo}}}, {emission, emission, emission}));
    b.camera({0, 0, 0}, {0.3, 0.2, -1}, 60);
    return b.scene();
}

/// Camera paths alone see the same at every bounce: each sample is the sum, exactly.
TEST(Furnace, WhiteAndClosedAddsUpEveryBounce) {
    RenderSettings settings = endless(IntegratorKind::Path, 1);
    settings.max_depth = kDepth;
    settings.strategies = {.direct_light = false, .connection = false, .light_image = false, .lens_hit = false};
    for (const IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
        settings.integrator = integrator;
        const Picture seen = picture(glowing_ball(1, 0.001), settings);
        const char* name = integrator == IntegratorKind::Path ? ", path" : ", bdpt";
        EXPECT_TRUE(at_most({"furnace", std::string("albedo 1, closed, depth 1000, emission found") + name,
                             "radiance (depth + 1) e: relative deviation of any pixel"},
                            deviation(seen, 0.001 * (kDepth + 1)), 1e-5));
    }
}

struct Finder {
    const char* name;
    IntegratorKind integrator;
    bool connection;  ///< of every vertex with every other: a million for each sample at depth 1000
    int depth;
};

TEST(Furnace, WhiteAndClosedIsTheSameHoweverLightIsFound) {
    for (const Finder& finder : {Finder{"path", IntegratorKind::Path, false, kDepth},
                                 Finder{"bdpt without connections", IntegratorKind::Bdpt, false, kDepth},
                                 Finder{"bdpt", IntegratorKind::Bdpt, true, 100}}) {
        RenderSettings settings = small_settings(finder.integrator, 4, 1);
        settings.light_paths_per_pixel = 1;
        settings.max_depth = finder.depth;
        settings.roulette_depth = -1;
        settings.strategies.connection = finder.connection;
        const Replicas seen = render_replicas(glowing_ball(1, 1.0 / (finder.depth + 1)), settings, kReplicas, 1);
        EXPECT_TRUE(mean_is(seen, 1, 0.02));
        EXPECT_TRUE(at_most({"furnace", "albedo 1, closed, depth " + std::to_string(finder.depth) + ", " + finder.name,
                             "radiance (depth + 1) e: relative deviation of the mean"},
                            relative_error(seen, 1), 0.05));
    }
}

/// Roulette must end what has no other end.
TEST(Furnace, WhiteAndClosedEndsByRoulette) {
    RenderSettings settings = small_settings(IntegratorKind::Path, 8, 16);
    settings.max_depth = 1'000'000;
    const Replicas seen = render_replicas(glowing_ball(0.9, 0.1), settings, kReplicas, 1);
    EXPECT_TRUE(mean_is(seen, 1, 0.01));
    EXPECT_TRUE(at_most({"furnace", "albedo 0.9, closed, depth 1e6, by roulette", "radiance e / (1 - albedo)"},
                        relative_error(seen, 1), 0.05));
}

}  // namespace
}  // namespace etendue::test
