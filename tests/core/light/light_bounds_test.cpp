// What a light says about its place and cone holds everything that it emits; unions hold both.

#include "light/light_bounds.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/light/light_cases.h"
#include "math/constants.h"
#include "math/frame.h"
#include "math/rng.h"
#include "math/sampling.h"

namespace etendue {
namespace {

constexpr double kSlack = 1e-9;

bool holds_point(const LightBounds& bounds, const Vec3& p) {
    const Vec3 outside = max(max(bounds.lower - p, p - bounds.upper), Vec3{});
    return max_component(outside) <= kSlack;
}

bool holds_normal(const LightBounds& bounds, const Vec3& n) {
    return bounds.cos_normals <= -1 || dot(bounds.axis, n) >= bounds.cos_normals - kSlack;
}

class Bounds : public testing::TestWithParam<test::LightCase> {};

TEST_P(Bounds, HoldAllThatIsEmitted) {
    const Light& light = *GetParam().light;
    const std::optional<LightBounds> bounds = light.bounds();
    ASSERT_NE(light.infinite(), bounds.has_value());
    if (!bounds) return;
    const bool point = light.delta();
    Vec3 lower = bounds->upper;
    Vec3 upper = bounds->lower;
    Rng rng(61, 0, 0);
    for (int i = 0; i < 3000; ++i) {
        const Vec2 u_point = rng.next_2d();
        const EmissionSample sample = light.sample_emission(u_point, rng.next_2d());
        ASSERT_TRUE(holds_point(*bounds, sample.y.p));
        if (is_black(sample.weight)) continue;
        const bool beam = bounds->cos_emission > 0;  // its axis stands for all normals
        ASSERT_TRUE(beam || holds_normal(*bounds, point ? sample.direction : sample.y.n));
        if (beam || !point) {
            ASSERT_GE(dot(sample.direction, beam ? bounds->axis : sample.y.n), bounds->cos_emission - kSlack);
        }
        lower = min(lower, sample.y.p);
        upper = max(upper, sample.y.p);
    }
    // No wider than need be.
    EXPECT_GE(length(upper - lower), 0.8 * length(bounds->upper - bounds->lower));
}

INSTANTIATE_TEST_SUITE_P(Lights, Bounds, testing::ValuesIn(test::all_lights_and_beams()), test::case_name);

TEST(LightBounds, EmissionMeasures) {
    LightBounds bounds;
    EXPECT_NEAR(bounds.emission_measure(), 4 * kPi, 1e-12);  // all around
    bounds.cos_normals = 1;
    EXPECT_NEAR(bounds.emission_measure(), kPi, 1e-12);  // flat and diffuse
    bounds.cos_emission = 0.5;
    EXPECT_NEAR(bounds.emission_measure(), kPi * 0.75, 1e-12);  // pi sin^2: a lamp with a screen
    bounds.cos_normals = 0;
    bounds.cos_emission = 0;
    EXPECT_NEAR(bounds.emission_measure(), 2 * kPi + kPi * kPi / 2, 1e-12);  // a half sphere's
}

TEST(LightBounds, UnionsHoldBoth) {
    Rng rng(62, 0, 0);
    const auto random = [&rng] {
        LightBounds bounds;
        bounds.lower = sample_uniform_sphere(rng.next_2d());
        bounds.upper = bounds.lower + abs(sample_uniform_sphere(rng.next_2d()));
        bounds.axis = sample_uniform_sphere(rng.next_2d());
        bounds.cos_normals = 1 - 2 * std::pow(rng.next_1d(), 3);
        bounds.cos_emission = rng.next_1d();
        return bounds;
    };
    int cones = 0;
    for (int i = 0; i < 2000; ++i) {
        const LightBounds a = random();
        LightBounds b = random();
        if (i % 4 == 0) b.axis = a.axis;
        if (i % 16 == 1) b.axis = -a.axis;
        const LightBounds both = enclose(a, b);
        if (both.cos_normals > -1) ++cones;
        for (const LightBounds& part : {a, b}) {
            ASSERT_TRUE(holds_point(both, part.lower));
            ASSERT_TRUE(holds_point(both, part.upper));
            ASSERT_LE(both.cos_emission, part.cos_emission);
            const Frame frame = Frame::from_normal(part.axis);
            for (int k = 0; k < 20; ++k) {
                const Vec3 n = sample_uniform_cone(rng.next_2d(), 1 - part.cos_normals);
                ASSERT_TRUE(holds_normal(both, frame.to_world(n)));
            }
        }
    }
    EXPECT_GT(cones, 400);
}

}  // namespace
}  // namespace etendue
