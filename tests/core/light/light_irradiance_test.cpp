// Irradiance in closed form, by next-event estimation and by tracing emission. All seeds are fixed; test::agrees
// states the false alarm rate.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "core/light/light_cases.h"
#include "math/constants.h"
#include "math/frame.h"
#include "math/rng.h"
#include "math/sampling.h"
#include "support/estimate.h"

namespace etendue {
namespace {

using test::agree;
using test::agrees;
using test::Estimate;

/// Unit radiance before any size factor.
LightDesc unit(LightKind kind, const Matrix4& world_from_light = {}) {
    LightDesc light;
    light.name = "/light";
    light.kind = kind;
    light.world_from_light = world_from_light;
    return light;
}

Estimate irradiance(const Light& light, const Vec3& receiver, const Vec3& n, int count = 200'000) {
    Rng rng(11, 0, 0);
    Estimate estimate;
    for (int i = 0; i < test::samples(count); ++i) {
        const auto sample = light.sample_direct(receiver, rng.next_2d());
        estimate.add(sample ? sample->weight.g * std::max(0.0, dot(sample->wi, n)) : 0);
    }
    return estimate;
}

/// A disk that receives on the side of its normal.
struct Patch {
    Vec3 center;
    Vec3 n;
    double radius;

    [[nodiscard]] double area() const { return kPi * radius * radius; }
    [[nodiscard]] Vec3 point(const Vec2& u) const {
        const Vec2 d = sample_concentric_disk(u);
        return center + Frame::from_normal(n).to_world({d.x * radius, d.y * radius, 0});
    }
    [[nodiscard]] bool hit_by(const Vec3& origin, const Vec3& direction) const {
        const double cos = -dot(direction, n);
        const double height = dot(origin - center, n);
        if (cos <= 0 || height <= 0) return false;
        return length(origin + direction * (height / cos) - center) < radius;
    }
};

Estimate patch_flux_by_direct_light(const Light& light, const Patch& patch, int count) {
    Rng rng(12, 0, 0);
    Estimate estimate;
    for (int i = 0; i < test::samples(count); ++i) {
        const Vec3 receiver = patch.point(rng.next_2d());
        const auto sample = light.sample_direct(receiver, rng.next_2d());
        estimate.add(sample ? sample->weight.g * std::max(0.0, dot(sample->wi, patch.n)) * patch.area() : 0);
    }
    return estimate;
}

Estimate patch_flux_by_particles(const Light& light, const Patch& patch, int count) {
    Rng rng(13, 0, 0);
    Estimate estimate;
    for (int i = 0; i < test::samples(count); ++i) {
        const Vec2 u_point = rng.next_2d();
        const EmissionSample sample = light.sample_emission(u_point, rng.next_2d());
        estimate.add(patch.hit_by(sample.origin, sample.direction) ? sample.weight.g : 0);
    }
    return estimate;
}

void expect_patch_flux(const Light& light, const Patch& patch, double expected, int particles = 1'000'000) {
    EXPECT_TRUE(agrees(patch_flux_by_direct_light(light, patch, 200'000), expected)) << "by direct light";
    EXPECT_TRUE(agrees(patch_flux_by_particles(light, patch, particles), expected, 0.005)) << "by particles";
}

/// E / L of a polygon that lies above the receiver's horizon (Lambert): half the sum over the edges of the angle times
/// the projection of the edge plane's normal.
double lambert_polygon(const std::array<Vec3, 4>& corners, const Vec3& receiver, const Vec3& n) {
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 a = normalize(corners[i] - receiver);
        const Vec3 b = normalize(corners[(i + 1) % 4] - receiver);
        const Vec3 axis = cross(a, b);
        sum += std::atan2(length(axis), dot(a, b)) * dot(normalize(axis), n);
    }
    return std::abs(sum) / 2;
}

/// Flux / (L pi A1) between coaxial parallel disks of radii r1, r2 at distance h.
double disk_form_factor(double r1, double r2, double h) {
    const double x = 1 + (h * h + r2 * r2) / (r1 * r1);
    return (x - std::sqrt(x * x - 4 * (r2 / r1) * (r2 / r1))) / 2;
}

TEST(Irradiance, RectAtAPoint) {
    for (const Matrix4& m : {Matrix4{}, test::scaling(2, 0.5, 3), test::scaling(-1, 1, 1), test::scaling(-1, -2, 1),
                             test::rotated(1.3, {0.5, 1, 2}), test::general(), test::general(-1)}) {
        LightDesc desc = unit(LightKind::Rect, m);
        desc.width = 1.5;
        desc.height = 0.8;
        const Transform t(m);
        const Vec3 front = normalize(t.normal({0, 0, -1}));
        for (const double distance : {0.5, 3.0}) {
            const Vec3 receiver = t.point({0.2, -0.3, 0}) + front * distance;
            const Vec3 n = normalize(-front + Vec3{0.1, 0.2, 0.1});
            const std::array<Vec3, 4> corners{t.point({-0.75, -0.4, 0}), t.point({0.75, -0.4, 0}),
                                              t.point({0.75, 0.4, 0}), t.point({-0.75, 0.4, 0})};
            // The tilted receiver must see all of it for Lambert's formula to hold.
            for (const Vec3& c : corners) ASSERT_GT(dot(c - receiver, n), 0);
            const auto light = make_light(desc, test::kBounds);
            EXPECT_TRUE(agrees(irradiance(*light, receiver, n), lambert_polygon(corners, receiver, n), 0.005));
            const Vec3 behind = t.point({0.2, -0.3, 0}) - front * distance;
            EXPECT_FALSE(light->sample_direct(behind, {0.5, 0.5}));
        }
    }
}

TEST(Irradiance, DiskOnAxis) {
    const auto light = make_light(unit(LightKind::Disk, test::scaling(2, 2, 5)), test::kBounds);  // radius 1
    for (const double d : {0.3, 1.0, 4.0}) {
        EXPECT_TRUE(agrees(irradiance(*light, {0, 0, -d}, {0, 0, 1}), kPi / (1 + d * d), 0.005)) << d;  // pi L sin^2
    }
}

TEST(Irradiance, DiskOntoACoaxialDisk) {
    const auto light = make_light(unit(LightKind::Disk, test::scaling(2, 2, 1)), test::kBounds);
    expect_patch_flux(*light, {{0, 0, -0.7}, {0, 0, 1}, 1.5}, kPi * kPi * disk_form_factor(1, 1.5, 0.7));
}

TEST(Irradiance, SphereAtAPoint) {
    // pi L (r/d)^2 on a facing surface, whatever the distance; radius 0.5 * 2.
    for (const double d : {1.0001, 1.1, 2.0, 100.0, 1e6}) {
        const auto light = make_light(unit(LightKind::Sphere, test::scaling(-2, 2, 2)), test::kBounds);
        EXPECT_TRUE(agrees(irradiance(*light, {0, d, 0}, {0, -1, 0}), kPi / (d * d))) << d;
    }
}

TEST(Irradiance, SphereOntoACoaxialDisk) {
    const auto light = make_light(unit(LightKind::Sphere), test::kBounds);
    const double h = 1.1;
    const double radius = 2;
    const double power = kPi * kPi;  // pi L 4 pi r^2, r = 0.5
    const double caught = (1 - h / std::hypot(h, radius)) / 2;
    expect_patch_flux(*light, {{0, 0, -h}, {0, 0, 1}, radius}, power * caught);
}

TEST(Irradiance, FarEllipsoidGivesItsProjectedArea) {
    // E = L / d^2 times the area of the shadow: along z that is pi a b.
    const auto light = make_light(unit(LightKind::Sphere, test::scaling(4, 0.6, 3)), test::kBounds);
    const double d = 1e6;
    EXPECT_TRUE(agrees(irradiance(*light, {0, 0, d}, {0, 0, -1}), kPi * 2 * 0.3 / (d * d)));
}

/// E / (pi L) of an element whose normal meets the axis of a tube at its end, at a right angle (Hamilton and Morgan
/// 1952); `length` and `distance` (from the axis) in radii.
double tube_form_factor(double length, double distance) {
    const double x = (1 + distance) * (1 + distance) + length * length;
    const double y = (1 - distance) * (1 - distance) + length * length;
    return std::atan(length / std::sqrt(distance * distance - 1)) / (kPi * distance) +
           length / kPi *
               ((x - 2 * distance) / (distance * std::sqrt(x * y)) *
                    std::atan(std::sqrt(x * (distance - 1) / (y * (distance + 1)))) -
                std::atan(std::sqrt((distance - 1) / (distance + 1))) / distance);
}

TEST(Irradiance, CylinderAtAPoint) {
    for (const double d : {1.5, 4.0, 40.0}) {
        const auto light = make_light(unit(LightKind::Cylinder, test::scaling(6, -2, 2)), test::kBounds);  // radius 1
        const double expected = kPi * 2 * tube_form_factor(3, d);
        EXPECT_TRUE(agrees(irradiance(*light, {0, 0, d}, {0, 0, -1}), expected, 0.006)) << d;
    }
}

TEST(Irradiance, FarCylinderGivesItsProjectedArea) {
    const auto light = make_light(unit(LightKind::Cylinder, test::scaling(2, 3, 5)), test::kBounds);
    const double d = 1e6;
    // Along z one sees the length 2 times the width 3.
    EXPECT_TRUE(agrees(irradiance(*light, {0, 0, d}, {0, 0, -1}), 6 / (d * d)));
}

TEST(Irradiance, CylinderShinesOutwardOnly) {
    const auto light = make_light(unit(LightKind::Cylinder), test::kBounds);
    for (const Vec3& inside : {Vec3{0, 0, 0}, Vec3{0.2, 0.3, 0.1}, Vec3{3, 0, 0}}) {  // the last before an open end
        EXPECT_FALSE(light->sample_direct(inside, {0.3, 0.6}));
    }
}

TEST(Irradiance, LineAtAPoint) {
    LightDesc desc = unit(LightKind::Cylinder, test::scaling(3, 1, 1));
    desc.treat_as_line = true;  // K = 2 r L = 1
    const auto light = make_light(desc, test::kBounds);
    const double h = 1.5;
    for (const double d : {0.4, 2.0}) {
        const double expected =
            h / (d * d + h * h) + std::atan(h / d) / d;  // K d^2 times the integral of 1 / (d^2 + x^2)^2
        EXPECT_TRUE(agrees(irradiance(*light, {0, d, 0}, {0, -1, 0}), expected, 0.006)) << d;
    }
    const Patch patch{{0, 0, -1}, {0, 0, 1}, 1.5};
    EXPECT_TRUE(agree(patch_flux_by_direct_light(*light, patch, 200'000),
                      patch_flux_by_particles(*light, patch, 500'000), 0.006));
}

TEST(Irradiance, PointOntoACoaxialDisk) {
    LightDesc desc = unit(LightKind::Sphere);
    desc.treat_as_point = true;
    const auto light = make_light(desc, test::kBounds);
    const double caught = (1 - 1.1 / std::hypot(1.1, 2)) / 2;
    expect_patch_flux(*light, {{0, 0, -1.1}, {0, 0, 1}, 2}, kPi * kPi * caught);
    EXPECT_TRUE(agrees(irradiance(*light, {3, 0, 0}, {-1, 0, 0}), kPi * 0.25 / 9));
}

TEST(Irradiance, DefaultSunIsThreePointThreeSixLux) {
    LightDesc sun = unit(LightKind::Distant, test::rotated(1));
    sun.intensity = 50000;
    const auto light = make_light(sun, test::kBounds);
    const Vec3 n = normalize(Transform(test::rotated(1)).vector({0, 0, 1}));
    EXPECT_NEAR(irradiance(*light, {}, n).mean(), 3.36, 0.005);
    // pi sin^2 t to first order beyond the solid angle; the exact value:
    const double expected = 50000 * 6.7204e-5;
    EXPECT_NEAR(irradiance(*light, {}, n).mean() / expected, 1, 1e-4);
    const Patch patch{test::kBounds.center, n, 4};
    expect_patch_flux(*light, patch, irradiance(*light, {}, n).mean() * patch.area());
}

TEST(Irradiance, WideAndDeltaSuns) {
    for (const double angle : {0.0, 1e-4, 20.0, 180.0, 250.0, 360.0}) {
        LightDesc sun = unit(LightKind::Distant);  // shines along -z
        sun.intensity = 7;
        sun.angle = angle;
        const double sin_t = std::sin(angle * kPi / 360);
        const double front = angle <= 180 ? kPi * sin_t * sin_t : kPi;  // what a facing surface gets from its own side
        const double expected = angle == 0 ? 7 : 7 * front;
        const auto light = make_light(sun, test::kBounds);
        EXPECT_TRUE(agrees(irradiance(*light, {}, {0, 0, 1}), expected)) << angle;
        const Patch patch{test::kBounds.center, {0, 0, 1}, 4};
        expect_patch_flux(*light, patch, expected * patch.area());

        sun.normalize = true;
        const double lux = angle <= 180 ? 7 : 7 / (2 - sin_t * sin_t);
        EXPECT_TRUE(agrees(irradiance(*make_light(sun, test::kBounds), {}, {0, 0, 1}), lux)) << angle;
    }
}

TEST(Irradiance, DomeIsPi) {
    const auto light = make_light(unit(LightKind::Dome), test::kBounds);
    const Vec3 n = normalize(Vec3{1, 2, -1});
    EXPECT_TRUE(agrees(irradiance(*light, {}, n), kPi, 0.005));
    const Patch patch{{1, 0, 1}, n, 4};
    EXPECT_TRUE(agrees(patch_flux_by_direct_light(*light, patch, 400'000), kPi * patch.area()));
    EXPECT_TRUE(agrees(patch_flux_by_particles(*light, patch, 1'000'000), kPi * patch.area(), 0.005));
}

TEST(Irradiance, MeshOfARectIsTheRect) {
    const Vec3 a{-1, -1, 0};
    const Vec3 b{1, -1, 0};
    const Vec3 c{1, 1, 0};
    const Vec3 d{-1, 1, 0};
    LightDesc desc = unit(LightKind::Mesh);
    desc.intensity = 3;
    const auto light = make_mesh_light(desc, {{{a, b, c}, {}}, {{a, a, c}, {}}, {{a, c, d}, {}}}, nullptr);
    const Vec3 receiver{0.2, 0.4, 1.2};
    EXPECT_TRUE(
        agrees(irradiance(*light, receiver, {0, 0, -1}), 3 * lambert_polygon({a, b, c, d}, receiver, {0, 0, -1})));
    EXPECT_NEAR(light->power().g, 12 * kPi, 1e-12);
    EXPECT_TRUE(irradiance(*light, {0, 0, -1}, {0, 0, 1}, 1000).mean() == 0);
}

/// Both techniques see the same flux where no closed form is at hand.
class BothWays : public testing::TestWithParam<test::LightCase> {};

TEST_P(BothWays, DirectLightAndParticlesAgree) {
    const Light& light = *GetParam().light;
    for (const Patch& patch : {Patch{{0.2, 0.1, -2}, normalize(Vec3{0.1, 0.2, 1}), 2},
                               Patch{{0.4, 2.2, 0.6}, normalize(Vec3{0, -1, -0.2}), 2}}) {
        const Estimate direct = patch_flux_by_direct_light(light, patch, 300'000);
        const Estimate particles = patch_flux_by_particles(light, patch, 1'000'000);
        if (direct.mean() == 0 && particles.mean() == 0) continue;
        EXPECT_TRUE(agree(direct, particles, 0.01));
    }
}

INSTANTIATE_TEST_SUITE_P(Lights, BothWays, testing::ValuesIn(test::surface_lights()), test::case_name);

class BeamBothWays : public testing::TestWithParam<test::LightCase> {};

/// Through a disk across the beam, which the narrow ones fall into wholly.
TEST_P(BeamBothWays, DirectLightAndParticlesAgree) {
    const Vec3 axis = normalize(GetParam().axis);
    const Vec3 center = GetParam().light->bounds()->center();
    const Patch patch{center + axis * 3.0, -axis, 1.2};
    EXPECT_TRUE(agree(patch_flux_by_direct_light(*GetParam().light, patch, 100'000),
                      patch_flux_by_particles(*GetParam().light, patch, 200'000), 0.02));
}

INSTANTIATE_TEST_SUITE_P(Beams, BeamBothWays, testing::ValuesIn(test::shaped_lights()), test::case_name);

}  // namespace
}  // namespace etendue
