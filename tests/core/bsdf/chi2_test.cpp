#include "support/chi2.h"

#include <gtest/gtest.h>

#include "math/constants.h"
#include "math/sampling.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

double cosine_density(const Vec3& w) { return std::max(0.0, w.z) * kInvPi; }

std::optional<Vec3> cosine_sample(Rng& rng) { return sample_cosine_hemisphere(rng.next_2d()); }

/// The judge itself: right samplers pass, with p-values that are not all alike; wrong ones fail.
TEST(Chi2, AcceptsRightSampler) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        EXPECT_TRUE(passes(chi2_sphere(cosine_sample, cosine_density, {}, {.seed = seed})));
    }
}

TEST(Chi2, AcceptsRightSamplerOnNarrowGrid) {
    const Vec3 axis{0.6, 0, 0.8};
    const double one_minus_cos_max = 1e-8;
    const Frame frame = Frame::from_normal(axis);
    const auto sampler = [&](Rng& rng) -> std::optional<Vec3> {
        return frame.to_world(sample_uniform_cone(rng.next_2d(), one_minus_cos_max));
    };
    const auto density = [&](const Vec3& w) {
        const Vec3 local = frame.to_local(w);
        const bool inside = local.z > 0 && one_minus_cos(local.x * local.x + local.y * local.y) <= one_minus_cos_max;
        return inside ? 1 / (2 * kPi * one_minus_cos_max) : 0;
    };
    EXPECT_TRUE(passes(chi2_sphere(sampler, density, narrow_grid(axis, 1.4e-4), {})));
}

TEST(Chi2, RejectedSamplesAreOneCell) {
    const auto half = [](Rng& rng) -> std::optional<Vec3> {
        const Vec3 w = sample_cosine_hemisphere(rng.next_2d());
        if (w.x < 0) return std::nullopt;
        return w;
    };
    const auto density = [](const Vec3& w) { return w.x < 0 ? 0 : cosine_density(w); };
    EXPECT_TRUE(passes(chi2_sphere(half, density, {}, {})));
    EXPECT_FALSE(chi2_sphere(half, cosine_density, {}, {}).passed);
    EXPECT_FALSE(chi2_sphere(cosine_sample, density, {}, {}).passed);
}

TEST(Chi2, RejectsWrongScaleWrongShapeAndWrongPlace) {
    if (!full_effort()) return;  // errors this small need all the samples
    const auto scaled = [](double s) { return [s](const Vec3& w) { return s * cosine_density(w); }; };
    EXPECT_FALSE(chi2_sphere(cosine_sample, scaled(1.02), {}, {}).passed);
    EXPECT_FALSE(chi2_sphere(cosine_sample, scaled(0.98), {}, {}).passed);
    const auto tilted = [](const Vec3& w) { return cosine_density(w) * (1 + 0.1 * w.x); };
    EXPECT_FALSE(chi2_sphere(cosine_sample, tilted, {}, {}).passed);
    const auto sphere = [](Rng& rng) -> std::optional<Vec3> { return sample_uniform_sphere(rng.next_2d()); };
    EXPECT_FALSE(chi2_sphere(sphere, cosine_density, {}, {}).passed);
    const auto wrong = [](Rng&) -> std::optional<Vec3> { return Vec3{std::nan(""), 0, 0}; };
    EXPECT_FALSE(chi2_sphere(wrong, cosine_density, {}, {}).passed);
}

TEST(Chi2, WorksOnTheUnitSquare) {
    const auto ramp = [](Rng& rng) -> std::optional<Vec2> { return Vec2{std::sqrt(rng.next_1d()), rng.next_1d()}; };
    EXPECT_TRUE(passes(chi2_square(ramp, [](const Vec2& p) { return 2 * p.x; }, {})));
    EXPECT_FALSE(chi2_square(ramp, [](const Vec2&) { return 1.0; }, {}).passed);
}

TEST(Chi2, SidakKeepsTheSuiteRate) {
    EXPECT_NEAR(sidak(1e-4, 1), 1e-4, 1e-18);
    EXPECT_NEAR(1 - std::pow(1 - sidak(0.3, 7), 7), 0.3, 1e-12);
}

}  // namespace
}  // namespace etendue::test
