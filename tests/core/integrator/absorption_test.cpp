// Absorption inside bodies (Beer's law): closed forms, every strategy alone, and that all integrators agree when light
// and camera lie in different media or the same.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "bsdf/fresnel.h"
#include "math/constants.h"
#include "support/replicas.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

constexpr double kRadians = kPi / 180;
constexpr double kReflectance = 0.5;
constexpr double kColor = 0.6;  ///< left after kDepth
constexpr double kDepth = 0.8;
const double kMu = -std::log(kColor) / kDepth;

DielectricMaterial absorbing(double ior, double roughness = 0) {
    DielectricMaterial m;
    m.ior = ior;
    m.roughness.value = roughness;
    m.transmission_tint.value = {kColor, kColor, kColor};
    m.transmission_depth = kDepth;
    return m;
}

LightDesc dome() {
    LightDesc light;
    light.kind = LightKind::Dome;
    return light;
}

RenderSettings shallow(IntegratorKind integrator, int samples_per_pixel, int max_depth) {
    RenderSettings settings = small_settings(integrator, 8, samples_per_pixel);
    settings.max_depth = max_depth;
    settings.roulette_depth = -1;
    return settings;
}

// ------------------------------------------------------------------------------------------------ closed forms

double transmittance(double cos, double ior) { return 1 - fresnel_dielectric(cos, ior); }

/// Straight through a slab under a uniform sky, after at most two more reflections inside: with T the transmittance of
/// a face, R its reflectance and a = exp(-mu d), the sky is seen with T^2 a, T^2 a^3 R^2 and so on, and by reflection
/// R, T^2 a^2 R ... Tints of crossings do not count any more.
TEST(Absorption, OfASlabUnderASky) {
    constexpr double kThickness = 0.5;
    constexpr double kAngle = 40;
    SceneBuilder b;
    const int glass = b.material(absorbing(1.5));
    b.quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, glass);
    b.quad({-50, -kThickness, -50}, {100, 0, 0}, {0, 0, 100}, glass);
    b.light(dome());
    const double cos = std::cos(kAngle * kRadians);
    b.camera({std::tan(kAngle * kRadians) * 2, 2, 0}, {0, 0, 0}, 0.001);
    const double t = transmittance(cos, 1.5);
    const double r = 1 - t;
    const double sin_t = std::sin(kAngle * kRadians) / 1.5;
    const double a = std::exp(-kMu * kThickness / std::sqrt(1 - sin_t * sin_t));
    const double below = t * t * a / (1 - r * r * a * a);
    const double above = r + t * t * a * a * r / (1 - r * r * a * a);
    for (IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
        SCOPED_TRACE(static_cast<int>(integrator));
        const Replicas seen = render_replicas(b.scene(), shallow(integrator, 64, 64), 16, 1);
        EXPECT_TRUE(mean_is(seen, below + above, 0.002));
    }
}

/// Water of depth 1 over a grey patch under a sun; the camera sees nothing but the patch. In the water (`camera` below
/// 0) or above it. A wall keeps out what would slip in below the surface's edge.
SceneBuilder pool(double camera) {
    SceneBuilder b;
    b.quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, b.material(absorbing(1.333)));
    b.quad({2, -1, 2}, {0, 0, -4}, {0, 1, 0}, b.diffuse(0));
    b.quad({-0.6, -1, 0.6}, {1.2, 0, 0}, {0, 0, -1.2}, b.diffuse(kReflectance));
    b.camera({0, camera, 0}, {0, -1, 0}, 0.5);
    return b;
}

class AbsorbingPool : public testing::TestWithParam<double> {
protected:
    /// Of the floor under a sun of 5 lux: E cos T exp(-mu d) falls on it (theory.md §5).
    [[nodiscard]] double floor_radiance() const {
        const double sin_t = std::sin(angle_) / 1.333;
        const double path = 1 / std::sqrt(1 - sin_t * sin_t);
        return kReflectance / kPi * 5 * std::cos(angle_) * transmittance(std::cos(angle_), 1.333) *
               std::exp(-kMu * path);
    }
    [[nodiscard]] LightDesc sun() const {
        LightDesc light;
        light.kind = LightKind::Distant;
        light.angle = 0;
        light.intensity = 5;
        light.normalize = true;
        light.world_from_light = look_at({std::sin(angle_), std::cos(angle_), 0}, {0, 0, 0});
        return light;
    }

    double angle_ = GetParam() * kRadians;
};

/// From the camera under water to the floor is 0.6 of a unit.
TEST_P(AbsorbingPool, FloorUnderWaterIsDimmed) {
    constexpr double kAbove = 0.6;
    SceneBuilder b = pool(kAbove - 1);
    b.light(sun());
    const double expected = floor_radiance() * std::exp(-kMu * kAbove);
    for (IntegratorKind integrator : {IntegratorKind::Light, IntegratorKind::Bdpt}) {
        SCOPED_TRACE(static_cast<int>(integrator));
        SceneDescription scene = b.scene();
        // A view wide enough for particles that is as far from the floor everywhere.
        scene.cameras[0].projection = CameraProjection::Orthographic;
        scene.cameras[0].horizontal_aperture = scene.cameras[0].vertical_aperture = 10;
        EXPECT_TRUE(mean_is(render_replicas(scene, shallow(integrator, 300, 2), 16, 1), expected, 0.015));
    }
}

INSTANTIATE_TEST_SUITE_P(Degrees, AbsorbingPool, testing::Values(0.0, 50.0));

/// Looking down from the air, L T / n^2 exp(-mu) of the floor's radiance L, under light that comes from everywhere
/// within an angle of the zenith, and the mirror image of that light.
TEST(Absorption, OfAPoolSeenFromAbove) {
    constexpr double kHalfAngle = 25;
    SceneBuilder b = pool(1);
    LightDesc sun;
    sun.kind = LightKind::Distant;
    sun.angle = 2 * kHalfAngle;
    sun.intensity = 5;
    sun.world_from_light = look_at({0, 1, 0}, {0, 0, 0});
    b.light(sun);
    double irradiance = 0;
    constexpr int kSteps = 2000;
    for (int i = 0; i < kSteps; ++i) {
        const double theta = (i + 0.5) / kSteps * kHalfAngle * kRadians;
        const double sin_t = std::sin(theta) / 1.333;
        irradiance += 5 * 2 * kPi * std::sin(theta) * std::cos(theta) * transmittance(std::cos(theta), 1.333) *
                      std::exp(-kMu / std::sqrt(1 - sin_t * sin_t)) * (kHalfAngle * kRadians / kSteps);
    }
    const double t = transmittance(1, 1.333);
    const double expected = kReflectance / kPi * irradiance * t / (1.333 * 1.333) * std::exp(-kMu) + (1 - t) * 5;
    for (IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
        SCOPED_TRACE(static_cast<int>(integrator));
        EXPECT_TRUE(mean_is(render_replicas(b.scene(), shallow(integrator, 300, 3), 16, 1), expected, 0.015));
    }
}

// --------------------------------------------------------------------------------------------- every strategy alone

/// Murky matter between surfaces, a lamp and a camera that all lie in it, and a frosted ball of air. The body is a cube
/// about all of it, which no path leaves.
SceneDescription submerged(bool with_lens) {
    SceneBuilder b;
    const int grey = b.diffuse(0.7);
    b.quad({-1.2, -0.9, 0.9}, {2.4, 0, 0}, {0, 0, -1.5}, grey);
    b.quad({-1.2, -0.6, -1}, {2.4, 0, 0}, {0, 1.7, 0.2}, grey);
    DielectricMaterial murky = absorbing(1.0);
    murky.transmission_tint.value = {0.5, 0.7, 0.9};
    murky.transmission_depth = 2;
    b.shape(CubeDesc{20}, b.material(murky));
    DielectricMaterial tinted = absorbing(1.2, 0.7);
    tinted.transmission_tint.value = {0.9, 0.5, 0.3};
    tinted.transmission_depth = 0.5;
    b.sphere({0, -0.1, 0}, 0.5, b.material(tinted));
    b.rect_light({0.2, 1.2, 0.2}, {-0.2, -1, -0.2}, 0.9, 0.9, 4);
    b.camera({0.1, 0.2, 3.8}, {0, 0, 0}, 36);
    if (with_lens) b.lens(0.8, 3.2);
    return b.scene();
}

constexpr int kSize = 12;
constexpr int kReplicas = 16;

Replicas render_alone(const SceneDescription& scene, int s, int t) {
    const int effort = s == 0 || t == 0 ? 3 : 1;
    RenderSettings settings = small_settings(IntegratorKind::Bdpt, kSize, 48 * effort);
    settings.single_strategy = Strategy{s, t};
    settings.max_depth = s + t - 2;
    settings.strategies = {s == 0, s == 1 && t >= 2, s >= 2 && t >= 2, t == 1, t == 0};
    return render_replicas(scene, settings, kReplicas, static_cast<std::uint64_t>(100 + 10 * s + t));
}

double resolution(int s, int t) {
    if (t == 0) return 0.12;
    if (s + t == 2) return 0.06;
    return s + t <= 3 ? 0.03 : 0.06;
}

TEST(Absorption, IsTheSameForEveryStrategy) {
    const SceneDescription scene = submerged(true);
    for (int k = 1; k <= 3; ++k) {
        const Strategy reference{k == 1 ? 0 : 1, k == 1 ? 2 : k};
        const Replicas expected = render_alone(scene, reference.s, reference.t);
        for (int s = 0; s <= k + 1; ++s) {
            const int t = k + 1 - s;
            if (s == reference.s) continue;
            SCOPED_TRACE("(s, t) = (" + std::to_string(s) + ", " + std::to_string(t) + ")");
            const int cell = t == 0 || s + t == 2 ? kSize : kSize / 2;
            EXPECT_TRUE(same_picture(expected.blocks(cell), render_alone(scene, s, t).blocks(cell), resolution(s, t)));
        }
    }
}

// ------------------------------------------------------------------------------------------------------ agreement

SceneBuilder lit_box() {
    SceneBuilder b;
    b.open_box(b.diffuse(0.6));
    b.rect_light({0.1, 0.95, 0}, {0, -1, 0}, 1.0, 1.0, 4);
    b.camera({0.1, 0.1, 3.8}, {0, 0, 0}, 36);
    return b;
}

DielectricMaterial tinted(const Color& color, double depth, double roughness) {
    DielectricMaterial m;
    m.transmission_tint.value = color;
    m.transmission_depth = depth;
    m.roughness.value = roughness;
    return m;
}

SceneDescription glass_ball() {
    SceneBuilder b = lit_box();
    b.sphere({0, -0.3, 0}, 0.55, b.material(tinted({0.9, 0.4, 0.2}, 0.5, 0)));
    return b.scene();
}

SceneDescription frosted_ball() {
    SceneBuilder b = lit_box();
    b.sphere({0, -0.3, 0}, 0.55, b.material(tinted({0.9, 0.4, 0.2}, 0.5, 0.5)));
    return b.scene();
}

/// A ball with a coloured core and a grey thing in the core; OpenPBR, part of which is opaque.
SceneDescription nested() {
    SceneBuilder b = lit_box();
    OpenPbrMaterial shell;
    shell.transmission_weight.value = 0.8;
    shell.transmission_color.value = {0.3, 0.8, 0.9};
    shell.transmission_depth = 0.6;
    shell.specular_roughness.value = 0.5;
    b.sphere({0, -0.2, 0}, 0.75, b.material(shell));
    DielectricMaterial core = tinted({0.9, 0.3, 0.2}, 0.4, 0.6);
    core.ior = 1.1;
    b.sphere({0.1, -0.2, 0}, 0.45, b.material(core));
    b.sphere({0.1, -0.2, 0.1}, 0.15, b.diffuse(0.8));
    return b.scene();
}

/// Lamp and camera under water in a closed basin, so that walls and floor light each other through it.
SceneDescription basin(double roughness) {
    SceneBuilder b;
    const int grey = b.diffuse(0.6);
    b.open_box(grey);
    b.quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0}, grey);  // front
    DielectricMaterial water = tinted({0.2, 0.5, 0.8}, 1, roughness);
    water.ior = 1.333;
    b.quad({-1, 0.3, 1}, {2, 0, 0}, {0, 0, -2}, b.material(water));
    b.rect_light({0.3, 0.1, 0}, {-0.5, -1, 0}, 0.6, 0.6, 3);
    b.rect_light({0, 0.95, 0}, {0, -1, 0}, 0.6, 0.6, 3);
    b.camera({0.8, -0.3, 0.8}, {0, -0.5, 0}, 60);
    return b.scene();
}

SceneDescription smooth_basin() { return basin(0); }
SceneDescription rough_basin() { return basin(0.6); }

/// A glowing mesh inside murky glass under a sky.
SceneDescription lamp_in_glass() {
    SceneBuilder b;
    b.quad({-3, -1, 3}, {6, 0, 0}, {0, 0, -6}, b.diffuse(0.5));
    b.sphere({0, 0, 0}, 0.8, b.material(tinted({0.9, 0.6, 0.3}, 0.4, 0.5)));
    Matrix4 small = translation({0, 0.1, 0});
    small.m[0] = small.m[5] = small.m[10] = 0.25;
    b.shape(low_polygon_sphere(6, 4, false), b.material(DiffuseMaterial{}, {8, 8, 8}), small);
    LightDesc sky = dome();
    sky.intensity = 0.3;
    b.light(sky);
    b.camera({0, 1, 5}, {0, -0.2, 0}, 40);
    return b.scene();
}

struct Case {
    const char* name;
    SceneDescription (*scene)();
    bool light_sees_all;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class AbsorptionAgreement : public testing::TestWithParam<Case> {};

TEST_P(AbsorptionAgreement, OfAllIntegrators) {
    const SceneDescription scene = GetParam().scene();
    constexpr int kSide = 12;
    const Replicas path = render_replicas(scene, small_settings(IntegratorKind::Path, kSide, 128), 16, 1);
    EXPECT_TRUE(
        same_picture(path, render_replicas(scene, small_settings(IntegratorKind::Bdpt, kSide, 32), 16, 2), 0.03));
    if (!GetParam().light_sees_all) return;
    EXPECT_TRUE(
        same_picture(path, render_replicas(scene, small_settings(IntegratorKind::Light, kSide, 64), 16, 3), 0.03));
}

INSTANTIATE_TEST_SUITE_P(Scenes, AbsorptionAgreement,
                         testing::Values(Case{"glass_ball", glass_ball, false},
                                         Case{"frosted_ball", frosted_ball, true}, Case{"nested", nested, true},
                                         Case{"smooth_basin", smooth_basin, false},
                                         Case{"rough_basin", rough_basin, true},
                                         Case{"lamp_in_glass", lamp_in_glass, false}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace etendue::test
