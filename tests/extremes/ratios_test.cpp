// Densities whose squares overflow float, or vanish in it: lamps and lenses of a millionth, all of it at scales of 1e-7
// and 1e10, where densities per area are 1e14 and 1e-20 times those of ordinary rooms. The weights' arithmetic alone is
// held against an oracle, with ratios up to 1e60, in core/integrator/mis_test.cpp.

#include "extremes/agreement.h"
#include "extremes/extreme.h"
#include "extremes/pictures.h"
#include "extremes/similar_scenes.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

/// A box with a lamp of a millionth, a ball of dull metal, and a lens of a millionth. The lamp's density by area is
/// 1e12, a ray's that finds it by chance is of the order of 1.
SceneDescription pinpoint_box() {
    SceneBuilder b;
    b.open_box(b.diffuse(0.6));
    b.rect_light({0.1, 0.9, 0}, {0, -1, 0}, 1e-6, 1e-6, 4);
    ConductorMaterial metal;
    metal.roughness.value = 0.5;
    b.sphere({0, -0.4, 0}, 0.5, b.material(metal));
    b.camera({0.1, 0.95, 3.8}, {0, 0, 0}, 36);  // above the lamp, which shines down: path cannot find it in the picture
    b.lens(1e-6, 3.5);
    return b.scene();
}

TEST(Ratios, ThatOverflowFloatGiveTheSamePicture) {
    for (const double scale : {1e-7, 1e10}) {
        for (const MisHeuristic heuristic : {MisHeuristic::Balance, MisHeuristic::Power}) {
            const auto seen = [&](IntegratorKind integrator, int samples_per_pixel) {
                RenderSettings settings = small_settings(integrator, 8, samples_per_pixel);
                settings.heuristic = heuristic;
                return render_replicas(scaled(pinpoint_box(), scale), settings, kReplicas,
                                       static_cast<std::uint64_t>(integrator));
            };
            const Replicas path = seen(IntegratorKind::Path, 64);
            const Replicas bdpt = seen(IntegratorKind::Bdpt, 16);
            EXPECT_TRUE(same_picture(path, bdpt, 0.05));
            const char* name = heuristic == MisHeuristic::Power ? ", power heuristic" : ", balance heuristic";
            EXPECT_TRUE(at_most({"ratios of densities", "a lamp and a lens of 1e-6, times " + in_words(scale) + name,
                                 "path and bdpt: standard errors apart"},
                                errors_apart(path, bdpt), kMostErrors));
        }
    }
}

}  // namespace
}  // namespace etendue::test
