// Pictures whose value is known: furnaces, irradiance under every kind of light, and light that has crossed water.

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
constexpr double kWater = 1.333;

LightDesc dome(double radiance) {
    LightDesc light;
    light.kind = LightKind::Dome;
    light.intensity = radiance;
    return light;
}

LightDesc sun(const Vec3& towards, double degrees, double intensity) {
    LightDesc light;
    light.kind = LightKind::Distant;
    light.angle = degrees;
    light.intensity = intensity;
    light.world_from_light = look_at(towards, {0, 0, 0});
    return light;
}

DielectricMaterial dielectric(double ior, double roughness = 0) {
    DielectricMaterial m;
    m.ior = ior;
    m.roughness.value = roughness;
    return m;
}

ConductorMaterial white_metal(double roughness) {
    ConductorMaterial m;
    m.reflectance.value = {1, 1, 1};
    m.roughness.value = roughness;
    return m;
}

// ------------------------------------------------------------------------------------------------- furnaces

/// A body under a uniform sky, filling the view.
SceneDescription furnace(const MaterialModel& body) {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1, b.material(body));
    b.light(dome(1));
    b.camera({0, 0, 4}, {0, 0, 0}, 19);
    return b.scene();
}

RenderSettings deep(IntegratorKind integrator, int samples_per_pixel) {
    RenderSettings settings = small_settings(integrator, 8, samples_per_pixel);
    settings.max_depth = 300;
    settings.roulette_depth = 8;
    return settings;
}

void expect_mean(const SceneDescription& scene, double expected, double resolution, int samples_per_pixel = 64) {
    for (IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
        SCOPED_TRACE(integrator == IntegratorKind::Path ? "path" : "bdpt");
        const Replicas seen = render_replicas(scene, deep(integrator, samples_per_pixel), 16, 1);
        EXPECT_TRUE(mean_is(seen, expected, resolution));
    }
}

TEST(WhiteFurnace, HidesWhatAbsorbsNothing) {
    expect_mean(furnace(DiffuseMaterial{{{1, 1, 1}}}), 1, 0.003);
    expect_mean(furnace(white_metal(0)), 1, 0.003);
    expect_mean(furnace(dielectric(1.5)), 1, 0.003);
    expect_mean(furnace(dielectric(kWater)), 1, 0.003);
}

TEST(WhiteFurnace, ShowsTheShareThatIsReflected) {
    expect_mean(furnace(DiffuseMaterial{{{0.37, 0.37, 0.37}}}), 0.37, 0.003);
}

/// Light that is scattered among walls many times before it leaves.
TEST(WhiteFurnace, HidesAnOpenBox) {
    SceneBuilder b;
    b.open_box(b.diffuse(1));
    b.light(dome(1));
    b.camera({0, 0, 4}, {0, 0, 0}, 20);
    expect_mean(b.scene(), 1, 0.01, 256);
}

/// Particles in a furnace rarely find the view; quadrants of the picture see enough of them for a t-test.
testing::AssertionResult light_sees(const SceneDescription& scene, const Replicas& path) {
    const Replicas light = render_replicas(scene, deep(IntegratorKind::Light, 1500), 16, 3);
    return same_picture(path.blocks(4), light.blocks(4), 0.03);
}

/// A single facet model loses what facets scatter twice: never a gain, and the same loss from either end.
TEST(WhiteFurnace, LosesToRoughnessFromEitherEnd) {
    for (const MaterialModel& model : {MaterialModel{white_metal(0.7)}, MaterialModel{dielectric(1.5, 0.8)}}) {
        SCOPED_TRACE(model.index());
        const SceneDescription scene = furnace(model);
        const Replicas path = render_replicas(scene, deep(IntegratorKind::Path, 64), 16, 1);
        EXPECT_TRUE(same_picture(path, render_replicas(scene, deep(IntegratorKind::Bdpt, 64), 16, 2), 0.005));
        EXPECT_TRUE(light_sees(scene, path));
        EXPECT_LT(path.mean(), 1 + 5 * path.standard_error());
        EXPECT_GT(path.mean(), 0.5);
    }
}

/// Values and densities of a rough surface meet in one picture: light that is found by sampling directions, and light
/// that is sampled itself. A density that is off by a few per cent shows.
TEST(WhiteFurnace, IsTheSameHoweverLightIsFound) {
    for (const MaterialModel& model : {MaterialModel{white_metal(0.7)}, MaterialModel{dielectric(1.5, 0.7)}}) {
        SCOPED_TRACE(model.index());
        const SceneDescription scene = furnace(model);
        RenderSettings settings = small_settings(IntegratorKind::Path, 8, 1000);
        settings.max_depth = 2;
        settings.strategies.direct_light = false;
        const Replicas found = render_replicas(scene, settings, 16, 1).blocks(4);
        settings.strategies = {.emission_hit = false};
        const Replicas sampled = render_replicas(scene, settings, 16, 2).blocks(4);
        EXPECT_TRUE(same_picture(found, sampled, 0.006));
    }
}

/// theory.md §8.5: eta^2 L inside a body. From the centre every direction can leave.
SceneDescription inside(const DielectricMaterial& body) {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1, b.material(body));
    b.light(dome(1));
    b.camera({0, 0, 0}, {0, 0, -1}, 80);
    return b.scene();
}

TEST(InsideGlass, RadianceIsScaledByTheSquaredIndex) {
    expect_mean(inside(dielectric(1.5)), 1.5 * 1.5, 0.003);
    expect_mean(inside(dielectric(kWater)), kWater * kWater, 0.003);
}

/// Particles arrive unscaled and must make the same picture. The surface is rough enough to be joined to the lens.
TEST(InsideGlass, ParticlesCarryTheSame) {
    const SceneDescription scene = inside(dielectric(1.5, 0.8));
    const Replicas path = render_replicas(scene, deep(IntegratorKind::Path, 64), 16, 1);
    EXPECT_TRUE(light_sees(scene, path));
    EXPECT_TRUE(same_picture(path, render_replicas(scene, deep(IntegratorKind::Bdpt, 64), 16, 2), 0.005));
    EXPECT_LT(path.mean(), 1.5 * 1.5 + 5 * path.standard_error());
    EXPECT_GT(path.mean(), 0.5 * 1.5 * 1.5);
}

// ------------------------------------------------------------------------------------------ irradiance on a plane

constexpr double kHeight = 2;  ///< of lights above the plane
constexpr double kReflectance = 0.5;

struct Lamp {
    const char* name;
    LightDesc (*light)();
    double irradiance;
};

void PrintTo(const Lamp& lamp, std::ostream* out) { *out << lamp.name; }

LightDesc overhead(LightKind kind) {
    LightDesc light;
    light.kind = kind;
    light.intensity = 3;
    light.radius = 0.7;
    light.width = 1.2;
    light.height = 1.6;
    light.world_from_light = look_at({0, kHeight, 0}, {0, 0, 0});
    return light;
}

/// Of a rectangle over the point below its centre, four times that of a quarter over its corner.
double under_rectangle(double radiance, double width, double height, double distance) {
    const double a = width / 2 / distance;
    const double b = height / 2 / distance;
    const double p = std::sqrt(1 + a * a);
    const double q = std::sqrt(1 + b * b);
    return 4 * radiance / 2 * (a / p * std::atan(b / p) + b / q * std::atan(a / q));
}

double squared(double x) { return x * x; }

const Lamp kLamps[]{
    {"rect", [] { return overhead(LightKind::Rect); }, under_rectangle(3, 1.2, 1.6, kHeight)},
    {"disk", [] { return overhead(LightKind::Disk); }, kPi * 3 * 0.49 / (0.49 + squared(kHeight))},
    {"sphere", [] { return overhead(LightKind::Sphere); }, kPi * 3 * 0.49 / squared(kHeight)},
    {"point", [] { return point_light({0, kHeight, 0}, 40); }, 10 / squared(kHeight)},
    {"oblique_point", [] { return point_light({kHeight, kHeight, 0}, 40); },
     10 / squared(kHeight) / 2 * std::sqrt(0.5)},
    {"dome", [] { return dome(0.8); }, kPi * 0.8},
    {"default_sun", [] { return sun({0, 1, 0}, 0.53, 50000); }, 50000 * kPi * squared(std::sin(0.265 * kRadians))},
    {"oblique_sun", [] { return sun({1, 1, 0}, 0.53, 50000); },
     50000 * kPi * squared(std::sin(0.265 * kRadians)) * std::sqrt(0.5)},
    {"broad_sun", [] { return sun({0.3, 1, 0}, 50, 2); }, 2 * kPi * squared(std::sin(25 * kRadians)) / std::sqrt(1.09)},
    {"delta_sun", [] { return sun({std::sqrt(3.0), 1, 0}, 0, 7); }, 3.5},
    {"normalized_sun",
     [] {
         LightDesc light = sun({0, 1, 0}, 2, 7);
         light.normalize = true;
         return light;
     },
     7},
};

class Irradiance : public testing::TestWithParam<Lamp> {
protected:
    /// The camera looks at the plane's origin.
    static SceneBuilder plane(double size, double view_degrees, const Vec3& from) {
        SceneBuilder b;
        b.quad({-size, 0, size}, {2 * size, 0, 0}, {0, 0, -2 * size}, b.diffuse(kReflectance));
        b.camera(from, {0, 0, 0}, view_degrees);
        return b;
    }
};

TEST_P(Irradiance, IsSeenOnTheFloor) {
    const Lamp& lamp = GetParam();
    SceneBuilder b = plane(1, 0.01, {0, 1.4, 4});  // beside the light
    b.light(lamp.light());
    const double expected = kReflectance / kPi * lamp.irradiance;
    for (IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
        SCOPED_TRACE(integrator == IntegratorKind::Path ? "path" : "bdpt");
        EXPECT_TRUE(mean_is(render_replicas(b.scene(), small_settings(integrator, 8, 128), 16, 1), expected, 0.002));
    }
}

/// Particles need a wide view; under a light at infinity all of the plane is as bright.
TEST_P(Irradiance, IsWhatParticlesBring) {
    const Lamp& lamp = GetParam();
    const LightDesc light = lamp.light();
    if (light.kind != LightKind::Distant && light.kind != LightKind::Dome) return;  // LightIsPath has them
    SceneBuilder b = plane(3, 40, {0, 6, 0});
    b.light(light);
    const double expected = kReflectance / kPi * lamp.irradiance;
    EXPECT_TRUE(
        mean_is(render_replicas(b.scene(), small_settings(IntegratorKind::Light, 8, 1000), 16, 2), expected, 0.005));
}

INSTANTIATE_TEST_SUITE_P(Lamps, Irradiance, testing::ValuesIn(kLamps),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Irradiance, OfTheDefaultSunIs336Lux) { EXPECT_NEAR(kLamps[6].irradiance / kPi, 1.0695, 5e-4); }

/// A mesh that glows by its material is a light like any other.
TEST(Irradiance, OfAGlowingMesh) {
    SceneBuilder b;
    b.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, b.diffuse(kReflectance));
    b.quad({-0.6, kHeight, -0.8}, {1.2, 0, 0}, {0, 0, 1.6}, b.material(DiffuseMaterial{{{0, 0, 0}}}, {3, 3, 3}));
    b.camera({0, 1.4, 4}, {0, 0, 0}, 0.05);
    const double expected = kReflectance / kPi * under_rectangle(3, 1.2, 1.6, kHeight);
    for (IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
        EXPECT_TRUE(mean_is(render_replicas(b.scene(), small_settings(integrator, 8, 128), 16, 1), expected, 0.002));
    }
}

// -------------------------------------------------------------------------------------------------- a flat pool

double transmittance(double cos, double ior) { return 1 - fresnel_dielectric(cos, ior); }

/// Water of depth 1 over a grey patch, wide enough for light to reach all of the patch through its surface; a black
/// wall keeps out what would slip in below its edge. The camera is in the water and sees the patch alone: what light
/// reaches it has crossed the surface once and been scattered once, if max_depth is 2.
SceneBuilder pool(double ior) {
    SceneBuilder b;
    b.quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, b.material(dielectric(ior)));
    b.quad({2, -1, 2}, {0, 0, -4}, {0, 1, 0}, b.diffuse(0));
    b.quad({-0.6, -1, 0.6}, {1.2, 0, 0}, {0, 0, -1.2}, b.diffuse(kReflectance));
    b.camera({0, -0.1, 0}, {0, -1, 0}, 2 * std::atan(0.5 / 0.9) / kRadians);
    return b;
}

RenderSettings wet(IntegratorKind integrator, int samples_per_pixel, int max_depth = 2) {
    RenderSettings settings = small_settings(integrator, 8, samples_per_pixel);
    settings.max_depth = max_depth;
    settings.roulette_depth = -1;
    return settings;
}

constexpr int kParticles = 2000;  ///< per pixel
constexpr double kPoolResolution = 0.01;

class PoolUnderDeltaSun : public testing::TestWithParam<double> {
protected:
    double cos_ = std::cos(GetParam() * kRadians);
    Vec3 towards_{std::sin(GetParam() * kRadians), std::cos(GetParam() * kRadians), 0};
};

/// Particles carry flux, and flux is not scaled by the index: E cos T(cos) falls on the floor (theory.md §5).
TEST_P(PoolUnderDeltaSun, FloorReceivesWhatIsTransmitted) {
    SceneBuilder b = pool(kWater);
    b.light(sun(towards_, 0, 5));
    const double expected = kReflectance / kPi * 5 * cos_ * transmittance(cos_, kWater);
    for (IntegratorKind integrator : {IntegratorKind::Light, IntegratorKind::Bdpt}) {
        SCOPED_TRACE(integrator == IntegratorKind::Light ? "light" : "bdpt");
        EXPECT_TRUE(mean_is(render_replicas(b.scene(), wet(integrator, kParticles), 16, 1), expected, kPoolResolution));
    }
}

/// Scaling particles like radiance is wrong by exactly the squared index, in every sample.
TEST_P(PoolUnderDeltaSun, WrongParticlesAreTooBrightByTheSquaredIndex) {
    SceneBuilder b = pool(kWater);
    b.light(sun(towards_, 0, 5));
    RenderSettings settings = wet(IntegratorKind::Light, kParticles);
    settings.adjoint.refraction = false;
    const double expected = kWater * kWater * kReflectance / kPi * 5 * cos_ * transmittance(cos_, kWater);
    const Replicas wrong = render_replicas(b.scene(), settings, 16, 1);
    EXPECT_TRUE(mean_is(wrong, expected, kPoolResolution));
    settings.adjoint.refraction = true;
    const Replicas right = render_replicas(b.scene(), settings, 16, 1);  // the same random numbers
    EXPECT_NEAR(wrong.mean() / right.mean(), kWater * kWater, 1e-6);
}

/// A pane of glass is crossed twice: E cos T^2, and two wrong factors cancel.
TEST_P(PoolUnderDeltaSun, PaneScalesNothing) {
    SceneBuilder b;
    const int glass = b.material(dielectric(1.5));
    b.quad({-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, glass);
    b.quad({-3, -0.2, -3}, {6, 0, 0}, {0, 0, 6}, glass);
    b.quad({-0.6, -1.2, 0.6}, {1.2, 0, 0}, {0, 0, -1.2}, b.diffuse(kReflectance));
    b.camera({0, -0.3, 0}, {0, -1.2, 0}, 2 * std::atan(0.5 / 0.9) / kRadians);
    b.light(sun(towards_, 0, 5));
    const double t = transmittance(cos_, 1.5);
    RenderSettings settings = wet(IntegratorKind::Light, kParticles, 3);
    const Replicas right = render_replicas(b.scene(), settings, 16, 1);
    EXPECT_TRUE(mean_is(right, kReflectance / kPi * 5 * cos_ * t * t, kPoolResolution));
    settings.adjoint.refraction = false;
    EXPECT_NEAR(render_replicas(b.scene(), settings, 16, 1).mean() / right.mean(), 1, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Degrees, PoolUnderDeltaSun, testing::Values(0.0, 45.0, 60.0));

/// A sun that paths from the camera find as well: all integrators see the same floor.
TEST(Pool, UnderABroadSun) {
    constexpr double kHalfAngle = 25;
    SceneBuilder b = pool(kWater);
    b.light(sun({0, 1, 0}, 2 * kHalfAngle, 5));
    double irradiance = 0;
    constexpr int kSteps = 2000;
    for (int i = 0; i < kSteps; ++i) {
        const double theta = (i + 0.5) / kSteps * kHalfAngle * kRadians;
        irradiance += 5 * 2 * kPi * std::sin(theta) * std::cos(theta) * transmittance(std::cos(theta), kWater) *
                      (kHalfAngle * kRadians / kSteps);
    }
    const double expected = kReflectance / kPi * irradiance;
    for (IntegratorKind integrator : {IntegratorKind::Light, IntegratorKind::Bdpt}) {
        SCOPED_TRACE(integrator == IntegratorKind::Light ? "light" : "bdpt");
        EXPECT_TRUE(mean_is(render_replicas(b.scene(), wet(integrator, kParticles), 16, 1), expected, kPoolResolution));
    }
    RenderSettings settings = wet(IntegratorKind::Path, 500);
    const Replicas path = render_replicas(b.scene(), settings, 16, 1);
    EXPECT_TRUE(mean_is(path, expected, kPoolResolution));
    // Camera paths carry importance, which the switch does not touch.
    settings.adjoint.refraction = false;
    EXPECT_EQ(path.images, render_replicas(b.scene(), settings, 16, 1).images);
}

/// Light of a point at height h, refracted, falls on the floor at radius r = h tan + tan_t of the angles above and in
/// the water (depth 1): E = I T sin dtheta / (r dr).
TEST(Pool, UnderAPointLight) {
    constexpr double kLampHeight = 0.8;
    SceneBuilder b = pool(kWater);
    b.light(point_light({0, kLampHeight, 0}, 20));
    const auto radius = [](double theta) {
        const double sin_t = std::sin(theta) / kWater;
        return kLampHeight * std::tan(theta) + sin_t / std::sqrt(1 - sin_t * sin_t);
    };
    const auto irradiance = [&](double r) {
        double low = 0;
        double high = 1.5;
        while (high - low > 1e-12) {
            const double middle = (low + high) / 2;
            (radius(middle) < r ? low : high) = middle;
        }
        constexpr double kStep = 1e-5;
        const double dr = (radius(low + kStep) - radius(low - kStep)) / (2 * kStep);
        return 5 * transmittance(std::cos(low), kWater) * std::sin(low) / (r * dr);
    };
    // The view is the square [-0.5, 0.5]^2 of the floor, seen at right angles.
    double mean = 0;
    constexpr int kCells = 60;
    for (int i = 0; i < kCells; ++i) {
        for (int j = 0; j < kCells; ++j) {
            mean += irradiance(0.5 * std::hypot((i + 0.5) / kCells, (j + 0.5) / kCells)) / (kCells * kCells);
        }
    }
    const double expected = kReflectance / kPi * mean;
    for (IntegratorKind integrator : {IntegratorKind::Light, IntegratorKind::Bdpt}) {
        SCOPED_TRACE(integrator == IntegratorKind::Light ? "light" : "bdpt");
        EXPECT_TRUE(mean_is(render_replicas(b.scene(), wet(integrator, kParticles), 16, 1), expected, kPoolResolution));
    }
}

}  // namespace
}  // namespace etendue::test
