// The emission pipeline, number by number (UsdLux 26.11).

#include "light/usd_lux.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <etendue/error.h>

#include "core/light/light_cases.h"
#include "math/constants.h"

namespace etendue {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

LightDesc plain(LightKind kind, const Matrix4& world_from_light = {}) {
    LightDesc light;
    light.name = "/World/Key";
    light.kind = kind;
    light.world_from_light = world_from_light;
    return light;
}

/// Radiance of the emitting side, straight down the first sample.
double emitted(const LightDesc& desc) {
    const auto light = make_light(desc, test::kBounds);
    const EmissionSample sample = light->sample_emission({0.4, 0.3}, {0.2, 0.6});
    return light->radiance(sample.y, sample.direction).g;
}

TEST(UsdLux, RadianceIsIntensityTimesColorTimesTint) {
    LightDesc light = plain(LightKind::Rect);
    light.intensity = 3;
    light.exposure = 2;
    light.color = {0.5, 1, -0.1};
    light.color_temperature_rgb = {1.0433, 0.9836, 1.0346};
    const Rgb radiance = lux_radiance(light, 7);
    EXPECT_DOUBLE_EQ(radiance.r, 12 * 0.5 * 1.0433);
    EXPECT_DOUBLE_EQ(radiance.g, 12 * 0.9836);
    EXPECT_EQ(radiance.b, 0);  // outside the gamut
    light.normalize = true;
    EXPECT_DOUBLE_EQ(lux_radiance(light, 7).g, 12 * 0.9836 / 7);
}

TEST(UsdLux, DistantSizeFactors) {
    const auto factor = [](double angle) {
        LightDesc light = plain(LightKind::Distant);
        light.angle = angle;
        return lux_distant_size_factor(lux_distant_half_angle(light));
    };
    EXPECT_EQ(factor(0), 1);
    EXPECT_EQ(factor(-5), 1);
    EXPECT_NEAR(factor(0.53), 6.7204e-5, 0.0001e-5);
    EXPECT_NEAR(factor(90), kPi / 2, 1e-12);
    EXPECT_NEAR(factor(180), kPi, 1e-12);
    EXPECT_NEAR(factor(270), kPi * 1.5, 1e-12);
    EXPECT_NEAR(factor(360), kPi * 2, 1e-12);
    EXPECT_NEAR(factor(500), kPi * 2, 1e-12);
}

TEST(UsdLux, NormalizeDividesByWorldArea) {
    struct Case {
        LightKind kind;
        Matrix4 world_from_light;
        double area;
    };
    const double ellipsoid = 2 * kPi * 9 * (1 + (1 / 9.0) / std::sqrt(8 / 9.0) * std::atanh(std::sqrt(8 / 9.0)));
    for (const Case& c :
         {Case{LightKind::Rect, {}, 1}, Case{LightKind::Rect, test::scaling(2, 3, 7), 6},
          Case{LightKind::Rect, test::scaling(-2, 3, 1), 6}, Case{LightKind::Rect, test::rotated(2, {1, 2, 3}), 4},
          Case{LightKind::Disk, {}, kPi / 4}, Case{LightKind::Disk, test::scaling(2, 3, 7), 6 * kPi / 4},
          Case{LightKind::Sphere, {}, kPi}, Case{LightKind::Sphere, test::rotated(2), 4 * kPi},
          Case{LightKind::Sphere, test::scaling(-2, 2, 2), 4 * kPi},
          Case{LightKind::Sphere, test::scaling(3, 3, 1), ellipsoid / 4}}) {
        LightDesc light = plain(c.kind, c.world_from_light);
        light.intensity = 5;
        EXPECT_NEAR(emitted(light), 5, 1e-12);
        light.normalize = true;
        EXPECT_NEAR(emitted(light), 5 / c.area, 1e-12);
        EXPECT_NEAR(make_light(light, test::kBounds)->power().g, 5 * kPi, 1e-11);  // whatever the size
    }
}

TEST(UsdLux, NormalizeOfMeshDistantAndDome) {
    LightDesc mesh = plain(LightKind::Mesh);
    mesh.normalize = true;
    EXPECT_NEAR(make_mesh_light(mesh, test::tetrahedron(), nullptr)->power().g, kPi, 1e-12);

    LightDesc distant = plain(LightKind::Distant);
    distant.normalize = true;
    EXPECT_NEAR(emitted(distant), 1 / 6.7204e-5, 1);

    LightDesc dome = plain(LightKind::Dome, test::scaling(3, 3, 3));
    dome.normalize = true;
    EXPECT_EQ(emitted(dome), 1);
}

TEST(UsdLux, NormalizeOfCylinderIsItsLateralArea) {
    // The second: an ellipse with half-axes 1 and 0.5, whose perimeter is 4 E(sqrt(3)/2).
    for (const auto& [m, area] :
         {std::pair{test::rotated(2), 8 * kPi * 0.5}, std::pair{test::scaling(3, 2, 1), 3 * 4.844224110273838},
          std::pair{test::scaling(-3, 1, 1), 3 * kPi}}) {
        LightDesc light = plain(LightKind::Cylinder, m);
        light.intensity = 5;
        EXPECT_NEAR(emitted(light), 5, 1e-12);
        light.normalize = true;
        EXPECT_NEAR(emitted(light), 5 / area, 1e-11);
        EXPECT_NEAR(make_light(light, test::kBounds)->power().g, 5 * kPi, 1e-10);
    }
}

TEST(UsdLux, LineLightsKeepThePower) {
    LightDesc light = plain(LightKind::Cylinder, test::rotated(2));
    light.intensity = 3;
    const double tube = make_light(light, test::kBounds)->power().g;
    light.treat_as_line = true;
    EXPECT_NEAR(make_light(light, test::kBounds)->power().g, tube, 1e-11);
    light.normalize = true;
    EXPECT_NEAR(make_light(light, test::kBounds)->power().g, 3 * kPi, 1e-11);
    light.treat_as_line = false;
    light.radius = 0;
    EXPECT_NEAR(make_light(light, test::kBounds)->power().g, 3 * kPi, 1e-11);
    light.normalize = false;  // there is no area to multiply by
    EXPECT_NEAR(make_light(light, test::kBounds)->power().g, 3 * kPi, 1e-11);
    light.length = 0;
    EXPECT_TRUE(is_black(make_light(light, test::kBounds)->power()));
    light.normalize = true;
    EXPECT_THROW((void)make_light(light, test::kBounds), SceneError);
    light.normalize = false;
    EXPECT_TRUE(is_black(make_light(light, test::kBounds)->power()));
}

TEST(UsdLux, PointLightsKeepTheFarField) {
    LightDesc light = plain(LightKind::Sphere, test::rotated(2));
    light.intensity = 3;
    light.treat_as_point = true;
    const double radius = 0.5 * 2;
    EXPECT_NEAR(make_light(light, test::kBounds)->power().g, 4 * kPi * 3 * kPi * radius * radius, 1e-11);
    light.normalize = true;  // I = intensity / 4
    EXPECT_NEAR(make_light(light, test::kBounds)->power().g, kPi * 3, 1e-11);
    light.radius = 0;
    EXPECT_NEAR(make_light(light, test::kBounds)->power().g, kPi * 3, 1e-11);
    light.normalize = false;
    EXPECT_NEAR(make_light(light, test::kBounds)->power().g, kPi * 3, 1e-11);
}

TEST(UsdLux, SmallNormalizedSphereTendsToThePoint) {
    LightDesc light = plain(LightKind::Sphere);
    light.normalize = true;
    const Vec3 receiver{0, 3, 4};
    light.radius = 0;
    const double point = make_light(light, test::kBounds)->sample_direct(receiver, {0.3, 0.4})->weight.g;
    EXPECT_NEAR(point, 0.25 / 25, 1e-15);
    for (const double radius : {1e-3, 1e-6, 1e-12}) {
        light.radius = radius;
        const double sphere = make_light(light, test::kBounds)->sample_direct(receiver, {0.3, 0.4})->weight.g;
        EXPECT_NEAR(sphere / point, 1, radius * radius + 1e-12) << radius;
    }
}

void expect_error(const LightDesc& light, const std::string& mention) {
    try {
        (void)make_light(light, test::kBounds);
        ADD_FAILURE() << "no error about " << mention;
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find(light.name), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find(mention), std::string::npos) << error.what();
    }
    EXPECT_THROW((void)make_light_shape(light), SceneError) << mention;
}

TEST(UsdLux, ErrorsNameTheLight) {
    const LightDesc good = plain(LightKind::Disk);
    const auto broken = [&](auto&& change) {
        LightDesc light = good;
        change(light);
        return light;
    };
    expect_error(broken([](LightDesc& l) { l.radius = -1; }), "radius");
    expect_error(broken([](LightDesc& l) { l.width = kNotANumber; }), "width");
    expect_error(broken([](LightDesc& l) { l.length = -1; }), "length");
    expect_error(broken([](LightDesc& l) { l.shaping = ShapingDesc{kNotANumber}; }), "focus");
    expect_error(broken([](LightDesc& l) { l.shaping = ShapingDesc{0, {}, kInfinity}; }), "cone angle");
    expect_error(broken([](LightDesc& l) { l.height = kInfinity; }), "height");
    expect_error(broken([](LightDesc& l) { l.intensity = -1; }), "intensity");
    expect_error(broken([](LightDesc& l) { l.exposure = kNotANumber; }), "exposure");
    expect_error(broken([](LightDesc& l) { l.color[1] = kNotANumber; }), "color");
    expect_error(broken([](LightDesc& l) { l.world_from_light.m[0] = 0; }), "singular");
}

TEST(UsdLux, LightsWithoutAreaAreDarkOrAnError) {
    for (LightDesc light : {plain(LightKind::Rect), plain(LightKind::Disk)}) {
        light.width = 0;
        light.radius = 0;
        const auto dark = make_light(light, test::kBounds);
        EXPECT_TRUE(is_black(dark->power()));
        EXPECT_FALSE(dark->sample_direct({0, 0, -1}, {0.5, 0.5}));
        EXPECT_FALSE(make_light_shape(light));
        light.normalize = true;
        EXPECT_THROW((void)make_light(light, test::kBounds), SceneError);
    }
    LightDesc blown = plain(LightKind::Disk);
    blown.exposure = 5000;
    EXPECT_THROW((void)make_light(blown, test::kBounds), SceneError);
    EXPECT_TRUE(is_black(make_mesh_light(plain(LightKind::Mesh), {}, nullptr)->power()));
    EXPECT_THROW((void)make_light(plain(LightKind::Mesh), test::kBounds), SceneError);
}

}  // namespace
}  // namespace etendue
