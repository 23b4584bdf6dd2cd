// A camera in the surface of water, or a millionth from it: it sees what lies on its side, and knows in what it lies.

#include <algorithm>
#include <cmath>
#include <string>

#include "extremes/agreement.h"
#include "extremes/extreme.h"
#include "extremes/furnace.h"
#include "extremes/pictures.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

constexpr double kHeights[]{1e-4, 1e-6, 0, -1e-6, -1e-4};
constexpr double kTint = 0.5;
constexpr double kDepth = 2;

/// A cube of water that bends nothing but absorbs; its surface is the plane of y = `level`.
SceneDescription water_cube(double level, double height, bool looks_up) {
    SceneBuilder b;
    DielectricMaterial water;
    water.ior = 1;
    water.transmission_tint.value = {kTint, kTint, kTint};
    water.transmission_depth = 1;
    b.shape(CubeDesc{kDepth}, b.material(water), translation({0, level - kDepth / 2, 0}));
    b.light(white_sky());
    const Vec3 eye{0.1, level + height, 0.1};
    b.camera(eye, eye + Vec3{0, looks_up ? 1.0 : -1.0, 0}, 1e-3);
    return b.scene();
}

TEST(Waterline, CameraKnowsItsSide) {
    for (const double level : {0.0, -0.4, 1000.3}) {
        for (const double height : kHeights) {
            if (std::abs(level) > 1 && std::abs(height) < 1e-5) continue;  // less than the float of the surface knows
            double worst = 0;
            for (const IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
                const RenderSettings settings = endless(integrator, 1);
                const double below = std::max(0.0, -height);
                worst = std::max(
                    {worst, deviation(picture(water_cube(level, height, true), settings), std::pow(kTint, below)),
                     deviation(picture(water_cube(level, height, false), settings), std::pow(kTint, kDepth - below))});
            }
            EXPECT_TRUE(at_most({"waterline", "camera at " + in_words(height) + " over water at " + in_words(level),
                                 "Beer's law, up and down: relative deviation of any pixel"},
                                worst, 1e-5));
        }
    }
}

/// A pool in a box, seen along its surface from within the box.
TEST(Waterline, PathAndBdptAgree) {
    for (const double height : kHeights) {
        SceneBuilder b;
        b.open_box(b.diffuse(0.6));
        DielectricMaterial water;
        water.ior = 1.333;
        b.quad({-1, -0.4, 1}, {2, 0, 0}, {0, 0, -2}, b.material(water));
        b.rect_light({0, 0.9, 0}, {0, -1, 0}, 1.8, 1.8, 4);
        b.camera({0.1, -0.4 + height, 0.8}, {0, -0.4, -1}, 70);
        const Replicas path = replicas(b.scene(), IntegratorKind::Path);
        const Replicas bdpt = replicas(b.scene(), IntegratorKind::Bdpt);
        EXPECT_TRUE(same_picture(path, bdpt, 0.05)) << height;
        EXPECT_TRUE(
            at_most({"waterline", "a pool, camera at " + in_words(height), "path and bdpt: standard errors apart"},
                    errors_apart(path, bdpt), kMostErrors));
    }
}

}  // namespace
}  // namespace etendue::test
