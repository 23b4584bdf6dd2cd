// Bodies of glass in one another, through one another, and in one place.

#include <algorithm>
#include <cmath>
#include <string>

#include "extremes/agreement.h"
#include "extremes/extreme.h"
#include "extremes/furnace.h"
#include "extremes/pictures.h"
#include "extremes/similar_scenes.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

struct Ball {
    Vec3 center;
    double radius;
    double ior;
};

struct Bodies {
    const char* name;
    std::vector<Ball> balls;
};

std::vector<Bodies> bodies() {
    std::vector<Ball> onion;
    for (int i = 0; i < 8; ++i) onion.push_back({{0, 0, 0}, 1 - 0.1 * i, 1.2 + 0.1 * i});
    return {{"a ball of air in glass", {{{0, 0, 0}, 1, 1.5}, {{0, 0, 0}, 0.6, 1 / 1.5}}},
            {"eight balls in one another", onion},
            {"balls that touch from inside", {{{0, 0, 0}, 1, 1.5}, {{0.5, 0, 0}, 0.5, 1.333}}},
            {"two balls through each other", {{{-0.4, 0, 0}, 0.8, 1.5}, {{0.4, 0, 0}, 0.8, 1.333}}},
            {"a ball twice in one place", {{{0, 0, 0}, 1, 1.5}, {{0, 0, 0}, 1, 1.5}}},
            {"walls 1e-5 apart", {{{0, 0, 0}, 1, 1.5}, {{0, 0, 0}, 1 - 1e-5, 1.333}}}};
}

SceneDescription scene_of(const std::vector<Ball>& balls, double roughness) {
    SceneBuilder b;
    for (const Ball& ball : balls) {
        DielectricMaterial glass;
        glass.ior = ball.ior;
        glass.roughness.value = roughness;
        b.sphere(ball.center, ball.radius, b.material(glass));
    }
    b.light(white_sky());
    b.camera({0, 0, 4}, {0, 0, 0}, 19);
    return b.scene();
}

/// Whatever indices meet at a wall, a path that goes in comes out with what it had.
TEST(Nesting, SmoothGlassCannotBeSeenInAFurnace) {
    for (const Bodies& body : bodies()) {
        double worst = 0;
        for (const IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
            worst = std::max(worst, deviation(picture(scene_of(body.balls, 0), endless(integrator, 16)), 1));
        }
        EXPECT_TRUE(at_most({"nested bodies", std::string(body.name) + ", smooth, in a white furnace",
                             "radiance 1: relative deviation of any pixel"},
                            worst, 1e-6));
    }
}

TEST(Nesting, PathAndBdptAgreeOnFrostedGlass) {
    for (const Bodies& body : bodies()) {
        const SceneDescription scene = scene_of(body.balls, 0.5);
        const Replicas path = replicas(scene, IntegratorKind::Path);
        const Replicas bdpt = replicas(scene, IntegratorKind::Bdpt);
        EXPECT_TRUE(same_picture(path, bdpt, 0.02)) << body.name;
        EXPECT_TRUE(
            at_most({"nested bodies", std::string(body.name) + ", frosted", "path and bdpt: standard errors apart"},
                    errors_apart(path, bdpt), kMostErrors));
    }
}

/// Balls in balls along one line, clear as air but for what they absorb: light goes straight, and Beer's law is all
/// there is.
TEST(Nesting, BallsInBallsAbsorbByTheirLengths) {
    constexpr int kBalls = 4;  // as deep as media go
    SceneBuilder b;
    double expected = 1;
    for (int i = 0; i < kBalls; ++i) {
        DielectricMaterial glass;
        glass.ior = 1;
        const double tint = 0.9 - 0.2 * i;
        glass.transmission_tint.value = {tint, tint, tint};
        glass.transmission_depth = 1;
        const double radius = 1 - 0.25 * i;
        b.sphere({0, 0, 0}, radius, b.material(glass));
        expected *= std::pow(tint, i + 1 < kBalls ? 0.5 : 2 * radius);
    }
    b.light(white_sky());
    b.orthographic({0, 0, 4}, {0, 0, 0}, 1e-4);
    for (const double scale : {1e-6, 1.0, 1e6}) {
        double worst = 0;
        for (const IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
            worst = std::max(worst, deviation(picture(scaled(b.scene(), scale), endless(integrator, 1)), expected));
        }
        EXPECT_TRUE(at_most({"nested bodies", "four absorbing balls in one another, times " + in_words(scale),
                             "Beer's law: relative deviation of any pixel"},
                            worst, 1e-6));
    }
}

}  // namespace
}  // namespace etendue::test
