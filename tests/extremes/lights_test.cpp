// Lights from a millionth to a thousand units wide, and of intensities from 1e-20 to 1e20. Irradiance by lights of
// ordinary size is tested in core/integrator/closed_form_test.cpp.

#include <algorithm>
#include <cmath>
#include <string>

#include "extremes/agreement.h"
#include "extremes/extreme.h"
#include "extremes/pictures.h"
#include "geometry/ray.h"
#include "math/constants.h"
#include "support/scene_builder.h"

namespace etendue::test {
namespace {

constexpr double kAlbedo = 0.5;
constexpr double kIntensity = 2;

LightDesc lamp_of(LightKind kind, double width, bool normalize) {
    LightDesc lamp;
    lamp.kind = kind;
    lamp.width = lamp.height = lamp.length = width;
    lamp.radius = width / 2;
    lamp.normalize = normalize;
    lamp.intensity = kIntensity;
    return lamp;
}

/// A floor about the origin, a lamp that high over it that looks down. The view is a square of that width.
SceneDescription floor_under(LightDesc lamp, double height, double view) {
    SceneBuilder b;
    b.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, b.diffuse(kAlbedo));
    lamp.world_from_light = look_at({0, height, 0}, {0, 0, 0});
    b.light(lamp);
    b.orthographic({0.1, 0.5, 0}, {0, 0, 0}, view);
    return b.scene();
}

struct TinyLamp {
    const char* name;
    LightKind kind;
    double intensity;  ///< candela towards the middle of its front, of a power of 1 by UsdLux's normalize
};

constexpr TinyLamp kTinyLamps[]{{"rect", LightKind::Rect, 1},
                                {"disk", LightKind::Disk, 1},
                                {"sphere", LightKind::Sphere, 0.25},
                                {"cylinder", LightKind::Cylinder, kInvPi}};
constexpr double kTinyWidths[]{1e-6, 1e-4, 1e-2};

/// The view is so small that no cosine differs from 1 by more than 1e-5.
TEST(Lights, TinyOnesShineLikePoints) {
    constexpr double kHeight = 0.8;
    for (const TinyLamp& lamp : kTinyLamps) {
        const double expected = kAlbedo / kPi * kIntensity * lamp.intensity / (kHeight * kHeight);
        for (const double width : kTinyWidths) {
            double worst = 0;
            for (const IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
                const SceneDescription scene = floor_under(lamp_of(lamp.kind, width, true), kHeight, 0.002);
                worst = std::max(worst, relative_error(replicas(scene, integrator, 4), expected));
            }
            EXPECT_TRUE(at_most({"lights", std::string(lamp.name) + " light, " + in_words(width) + " wide",
                                 "E = I / d^2: relative deviation of the mean"},
                                worst, lamp.kind == LightKind::Cylinder ? 0.02 : 2e-4));
        }
    }
}

/// Looking straight at it: rays hit its shape, and points of it are joined to the lens. A rect's corners are float in
/// Embree: what its edges may be off by is lost or won. The others' shapes are exact.
TEST(Lights, TinyOnesLookAsLargeAsTheyAre) {
    const Vec3 from{0.13, 0.8, -0.21};
    for (const TinyLamp& lamp : kTinyLamps) {
        for (const double width : kTinyWidths) {
            SceneBuilder b;
            b.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, b.diffuse(kAlbedo));
            LightDesc desc = lamp_of(lamp.kind, width, true);
            desc.world_from_light = look_at(from, {0, 0, 0});
            b.light(desc);
            const double view = 4 * width;
            b.orthographic(from * 0.5, from, view);
            double worst = 0;
            for (const IntegratorKind integrator : kIntegrators) {
                const Replicas seen = replicas(b.scene(), integrator, 64);
                worst = std::max(worst, relative_error(seen, kIntensity * lamp.intensity / (view * view)));
            }
            const double edges = lamp.kind == LightKind::Rect ? 4 * kFloatRounding * length(from) / width : 0;
            EXPECT_TRUE(
                at_most({"lights", std::string(lamp.name) + " light, " + in_words(width) + " wide, in the picture",
                         "its flux to the camera: relative deviation of the mean"},
                        worst, 0.02 + edges));
        }
    }
}

/// Of a square's form factor from a point before its middle, at the distance 1; A is half its width.
double square_form_factor(double a) {
    const double root = std::sqrt(1 + a * a);
    return 4 / kPi * a / root * std::atan(a / root);
}

TEST(Lights, HugeOnesFillTheSky) {
    constexpr double kWidth = 1000;
    struct HugeLamp {
        const char* name;
        LightKind kind;
        double height;  ///< of its middle; its surface is 1 above the floor
        double form_factor;
    };
    const HugeLamp lamps[]{{"rect", LightKind::Rect, 1, square_form_factor(kWidth / 2)},
                           {"disk", LightKind::Disk, 1, kWidth * kWidth / 4 / (1 + kWidth * kWidth / 4)},
                           {"sphere", LightKind::Sphere, 501, 500.0 * 500 / (501.0 * 501)}};
    for (const HugeLamp& lamp : lamps) {
        double worst = 0;
        for (const IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
            RenderSettings settings = small_settings(integrator, 8, 256);
            settings.max_depth = 1;
            const Replicas seen = render_replicas(floor_under(lamp_of(lamp.kind, kWidth, false), lamp.height, 0.002),
                                                  settings, kReplicas, 1);
            worst = std::max(worst, relative_error(seen, kAlbedo * kIntensity * lamp.form_factor));
        }
        EXPECT_TRUE(at_most({"lights", std::string(lamp.name) + " light, 1000 wide, 1 over the floor",
                             "E = pi L F: relative deviation of the mean"},
                            worst, 0.02));
    }
}

/// Everything is linear in intensity: by a power of two the picture is the same but for its exponents.
TEST(Lights, AnyIntensityGivesTheSamePicture) {
    for (const int exponent : {-66, 66}) {  // 1.4e-20 and 7.4e19
        const Worst worst = worst_of_all([exponent](SceneDescription scene, const RenderSettings& settings) {
            Picture original = picture(scene, settings);
            for (float& x : original.rgb) x = std::ldexp(x, exponent);
            for (LightDesc& light : scene.lights) light.intensity = std::ldexp(light.intensity, exponent);
            for (MaterialDesc& material : scene.materials) {
                for (double& x : material.emission.value) x = std::ldexp(x, exponent);
            }
            const Picture scaled = picture(scene, settings);
            return scaled.invalid > 0 ? kInfinity : pixels_that_differ(original, scaled);
        });
        EXPECT_TRUE(at_most({"lights", "intensities times 2^" + std::to_string(exponent) + ", " + worst.where,
                             "the picture, as many times brighter: pixels that differ in any bit"},
                            worst.figure, 0));
    }
}

/// A light that is forty orders fainter than another is not there, and harms nothing.
TEST(Lights, MayBeFortyOrdersApart) {
    const auto box = [](double intensity, double other) {
        SceneBuilder b;
        b.open_box(b.diffuse(0.5));
        b.rect_light({0.1, 0.9, 0}, {0, -1, 0}, 0.5, 0.5, intensity);
        if (other > 0) b.rect_light({0, 0.9, 0.5}, {0, -1, 0}, 0.3, 0.3, other);
        b.camera({0.1, 0.1, 3.8}, {0, 0, 0}, 36);
        return b.scene();
    };
    for (const IntegratorKind integrator : {IntegratorKind::Path, IntegratorKind::Bdpt}) {
        const Replicas both = replicas(box(1e20, 1e-20), integrator);
        const Replicas one = replicas(box(1e20, 0), integrator);
        EXPECT_TRUE(at_most(
            {"lights",
             std::string("1e20 and 1e-20 in one box, ") + (integrator == IntegratorKind::Path ? "path" : "bdpt"),
             "the picture of the bright one: standard errors apart"},
            errors_apart(both, one), kMostErrors));
    }
}

}  // namespace
}  // namespace etendue::test
