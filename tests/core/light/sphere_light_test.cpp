// Spheres at extreme sizes and distances, and their exact area.

#include "light/sphere_light.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/light/light_cases.h"
#include "light/ellipsoid_area.h"
#include "math/constants.h"
#include "math/rng.h"
#include "math/sampling.h"
#include "support/estimate.h"

namespace etendue {
namespace {

TEST(EllipsoidArea, Spheroids) {
    EXPECT_NEAR(ellipsoid_area(Transform{}) / (4 * kPi), 1, 1e-15);
    for (const double a : {1.0001, 2.0, 50.0, 1e6}) {
        const double e = std::sqrt(1 - 1 / (a * a));
        const double oblate = 2 * kPi * a * a * (1 + std::atanh(e) / (a * a * e));
        EXPECT_NEAR(ellipsoid_area(Transform(test::scaling(a, 1, a))) / oblate, 1, 1e-11) << a;
        const double prolate = 2 * kPi * (1 + a * std::acos(1 / a) / e);
        EXPECT_NEAR(ellipsoid_area(Transform(test::scaling(1, -a, 1))) / prolate, 1, 1e-11) << a;
    }
}

TEST(EllipsoidArea, AnyAffineMapAgainstItsMeanJacobian) {
    for (const Matrix4& m : {test::general(), test::general(-1), test::scaling(1, 2, 3), test::scaling(5, 0.01, 1)}) {
        const Transform t(m);
        Rng rng(21, 0, 0);
        test::Estimate area;
        for (int i = 0; i < test::samples(300'000); ++i) {
            const Vec3 n = sample_uniform_sphere(rng.next_2d());
            area.add(4 * kPi * std::abs(t.determinant()) * length(t.normal(n)));
        }
        EXPECT_TRUE(test::agrees(area, ellipsoid_area(t)));
    }
}

/// Rotating the axes must not change the digits: the eigenvalues are those of a full matrix then.
TEST(EllipsoidArea, RotationKeepsTheDigits) {
    const Transform stretch(test::scaling(3, 0.2, 1));
    const Transform turn(test::rotated(1));
    EXPECT_NEAR(ellipsoid_area(turn * stretch * turn) / ellipsoid_area(stretch), 1, 1e-14);
}

LightDesc sphere(double radius, const Vec3& center) {
    LightDesc light;
    light.name = "/light";
    light.kind = LightKind::Sphere;
    light.radius = radius;
    light.world_from_light = test::scaling(1, 1, 1, center);
    return light;
}

TEST(SphereLight, FarAndSmallKeepsItsDigits) {
    const double radius = 1e-6;
    const double distance = 1e3;
    const auto light = make_light(sphere(radius, {}), test::kBounds);
    const Vec3 receiver = Vec3{2, -1, 2} * (distance / 3);
    const double solid_angle = kPi * radius * radius / (distance * distance);
    Rng rng(22, 0, 0);
    test::Estimate squared_offset;  // from the axis, of points uniform in the disk: mean 1/2
    for (int i = 0; i < test::samples(100'000); ++i) {
        const auto s = light->sample_direct(receiver, rng.next_2d());
        ASSERT_TRUE(s);
        EXPECT_NEAR(s->weight.g / solid_angle, 1, 1e-9);
        EXPECT_NEAR(length(s->y.p) / radius, 1, 1e-12);
        EXPECT_NEAR(dot(s->y.n, s->y.p) / radius, 1, 1e-12);
        const double offset = length(cross(s->y.p, receiver)) / (distance * radius);
        squared_offset.add(offset * offset);
    }
    EXPECT_TRUE(test::agrees(squared_offset, 0.5));
}

TEST(SphereLight, SmallAndFarFromTheOriginKeepsItsNormal) {
    // 1e-3 at 1e6: the position holds seven digits of the radius, the normal all of them.
    const Vec3 center{1e6, -1e6, 1e6};
    const auto light = make_light(sphere(1e-3, center), test::kBounds);
    const Vec3 receiver = center + Vec3{0, 0, 5};
    Rng rng(23, 0, 0);
    for (int i = 0; i < 1000; ++i) {
        const auto s = light->sample_direct(receiver, rng.next_2d());
        ASSERT_TRUE(s);
        EXPECT_NEAR(s->pdf_point / light->pdf_direct(receiver, s->y), 1, 1e-9);
    }
}

TEST(SphereLight, ReceiverInsideGetsNothing) {
    for (const Matrix4& m : {Matrix4{}, test::scaling(2, 0.3, 1)}) {
        LightDesc desc = sphere(0.5, {});
        desc.world_from_light = m;
        const auto light = make_light(desc, test::kBounds);
        const LightPoint y = light->sample_emission({0.3, 0.4}, {0.5, 0.5}).y;
        for (const Vec3& receiver : {Vec3{0, 0, 0}, Vec3{0.01, 0.1, -0.2}}) {
            EXPECT_FALSE(light->sample_direct(receiver, {0.4, 0.7}));
            EXPECT_EQ(light->pdf_direct(receiver, y), 0);
        }
    }
}

TEST(SphereLight, ReceiverNextToTheSurfaceSeesHalfASphereOfRadiance) {
    const auto light = make_light(sphere(0.5, {}), test::kBounds);
    const Vec3 receiver{0, 0.5 * (1 + 1e-9), 0};
    Rng rng(24, 0, 0);
    test::Estimate irradiance;
    for (int i = 0; i < test::samples(100'000); ++i) {
        const auto s = light->sample_direct(receiver, rng.next_2d());
        ASSERT_TRUE(!s || dot(receiver - s->y.p, s->y.n) > 0);
        irradiance.add(s ? s->weight.g * -s->wi.y : 0);
    }
    EXPECT_TRUE(test::agrees(irradiance, kPi));
}

/// The density is per visible solid angle: with unit radiance the weight of a similarity is the solid angle exactly.
TEST(SphereLight, WeightIsTheSolidAngle) {
    LightDesc desc = sphere(0.5, {});
    desc.world_from_light = test::rotated(2, {1, 2, 3});
    const auto light = make_light(desc, test::kBounds);
    const Vec3 receiver{1, 2, 8};
    const double solid_angle = 2 * kPi * (1 - std::sqrt(1 - 1 / 25.0));
    Rng rng(25, 0, 0);
    for (int i = 0; i < 1000; ++i) {
        const auto s = light->sample_direct(receiver, rng.next_2d());
        ASSERT_TRUE(s);
        EXPECT_NEAR(s->weight.g / solid_angle, 1, 1e-7);
    }
}

}  // namespace
}  // namespace etendue
