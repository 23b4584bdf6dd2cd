// What a sample says about itself is what the density functions say about it.

#include <cmath>

#include <gtest/gtest.h>

#include "core/light/light_cases.h"
#include "math/constants.h"
#include "math/measure.h"
#include "math/rng.h"
#include "support/estimate.h"

namespace etendue {
namespace {

constexpr double kTolerance = 1e-9;

testing::AssertionResult close(double a, double b) {
    if (std::abs(a - b) <= kTolerance * std::max(std::abs(a), std::abs(b))) return testing::AssertionSuccess();
    return testing::AssertionFailure() << a << " is not " << b;
}

testing::AssertionResult close(const Rgb& a, const Rgb& b) {
    const bool same = close(a.r, b.r) && close(a.g, b.g) && close(a.b, b.b);
    if (same) return testing::AssertionSuccess();
    return testing::AssertionFailure() << a.r << ' ' << a.g << ' ' << a.b << " is not " << b.r << ' ' << b.g << ' '
                                       << b.b;
}

testing::AssertionResult close(const Vec3& a, const Vec3& b) {
    if (length(a - b) <= kTolerance * std::max(1.0, length(b))) return testing::AssertionSuccess();
    return testing::AssertionFailure() << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' '
                                       << b.z;
}

class LightConsistency : public testing::TestWithParam<test::LightCase> {
protected:
    const Light& light() const { return *GetParam().light; }
};

Vec3 random_receiver(Rng& rng) {
    const Vec2 u = rng.next_2d();
    return Vec3{u.x - 0.5, u.y - 0.5, rng.next_1d() - 0.5} * 8;
}

TEST_P(LightConsistency, DirectSampleMatchesItsDensities) {
    Rng rng(1, 0, 0);
    int lit = 0;
    for (int i = 0; i < 5000; ++i) {
        Vec3 receiver = random_receiver(rng);
        if (const auto bounds = light().bounds(); bounds && i % 2 == 0) {  // a narrow beam finds few at random
            receiver = bounds->center() + normalize(GetParam().axis) * 6.0 + receiver * 0.02;
        }
        const auto sample = light().sample_direct(receiver, rng.next_2d());
        if (!sample) continue;
        ++lit;
        ASSERT_TRUE(close(length(sample->wi), 1));
        ASSERT_TRUE(close(sample->pdf_point, light().pdf_direct(receiver, sample->y)));
        if (light().infinite()) {
            ASSERT_EQ(sample->distance, kInfinity);
            ASSERT_TRUE(close(sample->wi, sample->y.p));
            ASSERT_TRUE(close(sample->y.n, -sample->y.p));
        } else {
            ASSERT_TRUE(close(receiver + sample->wi * sample->distance, sample->y.p));
        }
        if (light().delta()) {
            ASSERT_TRUE(is_black(light().radiance(sample->y, -sample->wi)));
            continue;
        }
        const double per_w = light().infinite() ? 1 : 1 / area_per_solid_angle(receiver, sample->y.p, sample->y.n);
        const double pdf_w = sample->pdf_point * per_w;
        ASSERT_TRUE(close(sample->weight, light().radiance(sample->y, -sample->wi) / pdf_w));
        ASSERT_GT(max_component(sample->weight), 0);
    }
    EXPECT_GT(lit, 300);
}

TEST_P(LightConsistency, EmissionSampleMatchesItsDensities) {
    Rng rng(2, 0, 0);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 u_point = rng.next_2d();
        const EmissionSample sample = light().sample_emission(u_point, rng.next_2d());
        const EmissionPdf pdf = light().pdf_emission(sample.y, sample.direction);
        ASSERT_TRUE(close(length(sample.direction), 1));
        ASSERT_TRUE(close(sample.pdf.pdf_point, pdf.pdf_point));
        if (!is_black(sample.weight)) ASSERT_TRUE(close(sample.pdf.pdf_dir, pdf.pdf_dir));
        if (light().infinite()) {
            ASSERT_TRUE(close(sample.direction, -sample.y.p));
        } else {
            ASSERT_TRUE(close(sample.origin, sample.y.p));
        }
        if (light().delta()) continue;
        const double cos = light().infinite() ? 1 : dot(sample.direction, sample.y.n);
        if (is_black(sample.weight)) continue;  // a beam's direction that the point turns away from
        ASSERT_GE(cos, 0);
        if (cos < 1e-6) continue;
        const Rgb radiance = light().radiance(sample.y, sample.direction);
        ASSERT_TRUE(close(sample.weight, radiance * (cos / (pdf.pdf_point * pdf.pdf_dir))));
    }
}

TEST_P(LightConsistency, MeanEmissionIsThePower) {
    Rng rng(3, 0, 0);
    test::Estimate green;
    for (int i = 0; i < test::samples(200'000); ++i) {
        const Vec2 u_point = rng.next_2d();
        green.add(light().sample_emission(u_point, rng.next_2d()).weight.g);
    }
    EXPECT_TRUE(test::agrees(green, light().power().g));
}

TEST_P(LightConsistency, ErrorBoundHoldsTheFloatPosition) {
    if (light().infinite()) return;
    Rng rng(4, 0, 0);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 u = rng.next_2d();
        const LightPoint y = light().sample_emission(u, u).y;
        for (int axis = 0; axis < 3; ++axis) {
            const auto in_float = static_cast<double>(static_cast<float>(y.p[axis]));
            ASSERT_LE(std::abs(in_float - y.p[axis]), y.p_error[axis]);
        }
    }
}

TEST_P(LightConsistency, NothingLeavesTheBack) {
    if (light().infinite() || light().delta()) return;
    Rng rng(5, 0, 0);
    for (int i = 0; i < 100; ++i) {
        const Vec2 u = rng.next_2d();
        const EmissionSample sample = light().sample_emission(u, rng.next_2d());
        if (is_black(sample.weight)) continue;
        EXPECT_TRUE(is_black(light().radiance(sample.y, -sample.direction)));
        EXPECT_EQ(light().pdf_emission(sample.y, -sample.direction).pdf_dir, 0);
        const Vec3 behind = sample.y.p - sample.y.n * 0.01;
        EXPECT_EQ(light().pdf_direct(behind, sample.y), 0);
    }
}

TEST_P(LightConsistency, InfiniteLightsStartOutsideAndCoverTheScene) {
    if (!light().infinite()) return;
    Rng rng(6, 0, 0);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 u_point = rng.next_2d();
        const EmissionSample sample = light().sample_emission(u_point, rng.next_2d());
        const Vec3 from_center = sample.origin - test::kBounds.center;
        EXPECT_GT(length(from_center), test::kBounds.radius);
        EXPECT_LT(length(from_center), 2 * test::kBounds.radius);  // near enough for float
        EXPECT_LE(length(cross(from_center, sample.direction)), test::kBounds.radius * (1 + 1e-12));
        EXPECT_LT(dot(from_center, sample.direction), 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Lights, LightConsistency, testing::ValuesIn(test::all_lights_and_beams()), test::case_name);

}  // namespace
}  // namespace etendue
