// Roughness on its way to smooth. Below alpha = kSmoothAlpha, a roughness of 0.00316, a lobe is a delta: nothing may
// change there but the kind of sampling, neither the picture nor its noise.

#include <algorithm>
#include <cmath>

#include "bsdf/ggx.h"
#include "extremes/agreement.h"
#include "extremes/extreme.h"
#include "extremes/furnace.h"
#include "extremes/pictures.h"
#include "support/scene_builder.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

constexpr IntegratorKind kFromTheCamera[]{IntegratorKind::Path, IntegratorKind::Bdpt};

struct Model {
    const char* name;
    MaterialModel (*of)(double roughness);
};

MaterialModel metal(double roughness) {
    ConductorMaterial m;
    m.reflectance.value = {1, 1, 1};
    m.roughness.value = roughness;
    return m;
}
MaterialModel glass(double roughness) {
    DielectricMaterial m;
    m.roughness.value = roughness;
    return m;
}
MaterialModel pane(double roughness) {
    DielectricMaterial m;
    m.roughness.value = roughness;
    m.thin_walled = true;
    return m;
}
MaterialModel coated(double roughness) {
    OpenPbrMaterial m;
    m.base_metalness.value = 1;
    m.specular_roughness.value = roughness;
    m.coat_weight.value = 1;
    m.coat_roughness.value = roughness;
    return m;
}

constexpr Model kModels[]{{"metal", metal}, {"glass", glass}, {"a pane", pane}, {"coated metal", coated}};

SceneDescription box_with(const MaterialModel& ball) {
    SceneDescription scene = glass_box();
    scene.materials.back().model = ball;
    return scene;
}

TEST(Roughness, ThatNobodyCanSeeIsNone) {
    int different = 0;
    for (const Model& model : kModels) {
        for (const IntegratorKind integrator : kIntegrators) {
            const RenderSettings settings = quick_settings(integrator);
            const Picture smooth = picture(box_with(model.of(0)), settings);
            for (const double roughness : {1e-5, 1e-4, 1e-3}) {
                different += pixels_that_differ(smooth, picture(box_with(model.of(roughness)), settings));
            }
        }
    }
    EXPECT_TRUE(
        at_most({"roughness", "1e-5, 1e-4, 1e-3 and 0", "the picture: pixels that differ in any bit"}, different, 0));
}

/// Roughnesses on either side of the switch.
constexpr double kLastSmooth = 0.00316;
constexpr double kFirstRough = 0.00317;
static_assert(kLastSmooth * kLastSmooth < kSmoothAlpha && kFirstRough * kFirstRough > kSmoothAlpha);

TEST(Roughness, SwitchesWithoutAJumpOrFireflies) {
    for (const Model& model : kModels) {
        for (const IntegratorKind integrator : kFromTheCamera) {
            const std::string where =
                std::string(model.name) + (integrator == IntegratorKind::Path ? ", path" : ", bdpt");
            const Replicas smooth = replicas(box_with(model.of(kLastSmooth)), integrator);
            const Replicas rough = replicas(box_with(model.of(kFirstRough)), integrator);
            EXPECT_TRUE(same_picture(smooth, rough, 0.02));
            EXPECT_TRUE(at_most({"roughness", "0.00316 and 0.00317, " + where, "the mean: standard errors apart"},
                                errors_apart(smooth, rough), kMostErrors));
            EXPECT_TRUE(at_most({"roughness", "0.00316 and 0.00317, " + where, "variance of pixels: rough / smooth"},
                                rough.mean_pixel_variance() / smooth.mean_pixel_variance(), 1.5));
        }
    }
}

/// What facets hide of each other is nothing yet. Next-event estimation now takes part, and finds the far tail of the
/// lobe; of a pixel's 16 samples one may be heavier by a few per cent. What darkens all of them shows.
TEST(Roughness, JustRoughIsWhiteInAFurnace) {
    for (const Model& model : {kModels[0], kModels[1], kModels[2]}) {
        double worst = 0;
        for (const IntegratorKind integrator : kFromTheCamera) {
            worst = std::max(worst, deviation(picture(furnace(model.of(kFirstRough)), endless(integrator, 16)), 1));
        }
        EXPECT_TRUE(at_most({"roughness", std::string("0.00317, ") + model.name + " in a white furnace",
                             "radiance 1: relative deviation of any pixel"},
                            worst, 1e-2));
    }
}

}  // namespace
}  // namespace etendue::test
