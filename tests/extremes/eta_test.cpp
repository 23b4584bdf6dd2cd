// Indices of refraction next to 1 and far from it, at and about the critical angle and next to grazing. Formulas alone
// are tested in core/bsdf/bsdf_limits_test.cpp; here whole renders have a known value.

#include <algorithm>
#include <cmath>

#include "extremes/extreme.h"
#include "extremes/furnace.h"
#include "extremes/pictures.h"
#include "math/constants.h"
#include "support/replicas.h"
#include "support/scene_builder.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

struct Index {
    const char* name;
    double value;
};
constexpr Index kIndices[]{{"1", 1},           {"1 - 1e-6", 1 - 1e-6}, {"1 + 1e-6", 1 + 1e-6},
                           {"1.0001", 1.0001}, {"1.333", 1.333},       {"2.4", 2.4},
                           {"4", 4},           {"1 / 2.4", 1 / 2.4}};
constexpr IntegratorKind kFromTheCamera[]{IntegratorKind::Path, IntegratorKind::Bdpt};

/// Floats of the picture round by 2^-24; the rest is for sums over samples.
constexpr double kStoredAsFloat = 0x1p-21;

DielectricMaterial glass(double ior, double roughness = 0) {
    DielectricMaterial m;
    m.ior = ior;
    m.roughness.value = roughness;
    return m;
}

TEST(Eta, SmoothGlassCannotBeSeenInAFurnace) {
    for (const auto& [name, ior] : kIndices) {
        double worst = 0;
        for (const IntegratorKind integrator : kFromTheCamera) {
            worst = std::max(worst, deviation(picture(furnace(glass(ior)), endless(integrator, 16)), 1));
        }
        EXPECT_TRUE(at_most({"index", std::string("a smooth ball of index ") + name + " in a white furnace",
                             "radiance 1: relative deviation of any pixel"},
                            worst, kStoredAsFloat));
    }
}

/// Exactly 1 is a case of its own in the code; the picture must not notice. What a difference of 1e-6 bends, and
/// reflects at grazing angles, is of its order.
TEST(Eta, OneIsApproachedWithoutAJump) {
    for (const double roughness : {0.0, 0.5}) {
        double worst = 0;
        for (const IntegratorKind integrator : kIntegrators) {
            const auto box = [&](double ior) {
                SceneDescription scene = glass_box();
                scene.materials.back().model = glass(ior, roughness);
                return picture(scene, quick_settings(integrator));
            };
            const Picture nothing = box(1);
            for (const double ior : {1 - 1e-6, 1 + 1e-6}) {
                worst = std::max(worst, relative_difference(nothing, box(ior)));
            }
        }
        EXPECT_TRUE(
            at_most({"index", "1 and 1 +- 1e-6, roughness " + in_words(roughness), "the picture: relative difference"},
                    worst, 1e-4));
    }
}

/// A plane of glass seen along parallel rays, from above or from inside, at `angle` from its normal; only what it
/// reflects, or what it lets through, is white.
SceneDescription interface_at(double angle, double ior, bool from_inside, bool reflected) {
    DielectricMaterial m = glass(ior);
    (reflected ? m.transmission_tint : m.reflection_tint).value = {0, 0, 0};
    SceneBuilder b;
    b.quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, b.material(m));
    b.light(white_sky());
    const Vec3 from{0, std::sin(angle), (from_inside ? -1 : 1) * std::cos(angle)};
    b.orthographic(from, {0, 0, 0}, std::abs(from.z) / 2);
    return b.scene();
}

/// Fresnel's reflectance by Snell's law, in extended precision; `ior` is beyond over here.
long double reflectance(long double cos, long double ior) {
    const long double sin2 = (1 - cos * cos) / (ior * ior);
    if (sin2 >= 1) return 1;
    const long double cos_t = std::sqrt(1 - sin2);
    const long double s = (cos - ior * cos_t) / (cos + ior * cos_t);
    const long double p = (ior * cos - cos_t) / (ior * cos + cos_t);
    return (s * s + p * p) / 2;
}

struct View {
    const char* name;
    double angle;
    bool from_inside;
};

std::vector<View> views(double ior) {
    const double grazing = 89.999 * kPi / 180;
    std::vector<View> all{{"along the normal", 0, false},
                          {"89.999 degrees", grazing, false},
                          {"89.999 degrees from inside", grazing, true}};
    if (ior <= 1) return all;
    const double critical = std::asin(1 / ior);
    all.push_back({"the critical angle - 1e-6", critical - 1e-6, true});
    all.push_back({"the critical angle - 1e-10", critical - 1e-10, true});
    all.push_back({"the critical angle + 1e-6", critical + 1e-6, true});
    return all;
}

/// What is let through is 1 - F; where little is, that little is a difference of the angle's own rounding.
double worst_at(const View& view, double ior) {
    // The camera looks along a direction that was rounded to double: its own cosine counts.
    const double cos = std::cos(view.angle);
    const double relative_ior = view.from_inside ? 1 / ior : ior;
    const auto f = static_cast<double>(reflectance(cos, relative_ior));
    const auto transmitted = static_cast<double>((1 - reflectance(cos, relative_ior)) /
                                                 (relative_ior * static_cast<long double>(relative_ior)));
    double worst = 0;
    for (const IntegratorKind integrator : kFromTheCamera) {
        const auto seen = [&](bool reflected) {
            return picture(interface_at(view.angle, ior, view.from_inside, reflected), endless(integrator, 1));
        };
        worst = std::max(worst, deviation(seen(true), f));
        worst = std::max(worst, transmitted > 0 ? deviation(seen(false), transmitted) : seen(false).mean());
    }
    return worst;
}

TEST(Eta, PlanesReflectByFresnelAtAnyAngle) {
    for (const auto& [name, ior] : kIndices) {
        if (ior == 1) continue;
        double worst = 0;
        std::string where;
        for (const View& view : views(ior)) {
            const double figure = worst_at(view, ior);
            if (figure > worst) where = view.name;
            worst = std::max(worst, figure);
        }
        EXPECT_TRUE(at_most({"index", std::string("a plane of index ") + name + ", worst: " + where,
                             "F and (1 - F) / eta^2: relative deviation"},
                            worst, kStoredAsFloat));
    }
}

}  // namespace
}  // namespace etendue::test
