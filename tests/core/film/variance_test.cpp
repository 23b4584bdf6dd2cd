// The variance that a render claims for its pixels is the scatter of renders of other seeds.

#include <cmath>

#include <gtest/gtest.h>

#include <etendue/render_session.h>

#include "support/estimate.h"
#include "support/replicas.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

/// Of two renders with seeds of their own, claimed variances less half the squared difference: expected 0, pixel by
/// pixel and for any distribution. Pixels are weighted with `weights`, so that none drowns the others.
double excess(const RenderedImage& a, const RenderedImage& b, const std::vector<double>& weights) {
    const auto& mean_a = a.find(Aov::Color)->data;
    const auto& mean_b = b.find(Aov::Color)->data;
    const auto& claim_a = a.find(Aov::Variance)->data;
    const auto& claim_b = b.find(Aov::Variance)->data;
    double sum = 0;
    for (std::size_t i = 0; i < mean_a.size(); ++i) {
        const double d = static_cast<double>(mean_a[i]) - static_cast<double>(mean_b[i]);
        sum += weights[i] * ((static_cast<double>(claim_a[i]) + static_cast<double>(claim_b[i])) / 2 - d * d / 2);
    }
    return sum / static_cast<double>(mean_a.size());
}

class Variance : public testing::TestWithParam<IntegratorKind> {};

TEST_P(Variance, IsTheScatterOverSeeds) {
    // Replicates of two or three passes, whose samples depend on each other.
    RenderSettings settings = small_settings(GetParam(), 8, 19);
    settings.aovs = {Aov::Color, Aov::Variance};
    const SceneDescription scene = diffuse_box();
    const auto seeded = [&](std::uint64_t seed) {
        settings.seed = seed;
        return render(scene, settings);
    };
    // Weights from a render of its own: independent of what is tested.
    const RenderedImage pilot = seeded(1000);
    double mean_claim = 0;
    for (float v : pilot.find(Aov::Variance)->data) mean_claim += static_cast<double>(v);
    mean_claim /= static_cast<double>(pilot.find(Aov::Variance)->data.size());
    std::vector<double> weights;
    for (float v : pilot.find(Aov::Variance)->data) weights.push_back(1 / (static_cast<double>(v) + mean_claim));

    Estimate difference;
    Estimate claim;
    const int pairs = samples(40000) / 100;
    for (int i = 0; i < pairs; ++i) {
        const RenderedImage a = seeded(static_cast<std::uint64_t>(2 * i));
        const RenderedImage b = seeded(static_cast<std::uint64_t>(2 * i + 1));
        difference.add(excess(a, b, weights));
        claim.add(excess(a, a, weights));  // no difference: the claim itself
    }
    EXPECT_LE(std::abs(difference.mean()), kSigmas * difference.standard_error());
    // Resolves a claim that is off by a third: n for n - 1 is 14 %, a sample's variance for the mean's 1100 %.
    if (full_effort()) EXPECT_LT(kSigmas * difference.standard_error(), claim.mean() / 3);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Variance,
                         testing::Values(IntegratorKind::Path, IntegratorKind::Light, IntegratorKind::Bdpt));

}  // namespace
}  // namespace etendue::test
