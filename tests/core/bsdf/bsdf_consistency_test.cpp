// sample(), eval_cos() and pdf() say the same; both modes are each other's adjoint.

#include <cmath>

#include <gtest/gtest.h>

#include "support/bsdf_cases.h"

namespace etendue::test {
namespace {

constexpr int kPairs = 300;

/// |a - b| relative to the larger channel of either.
double relative_difference(const Rgb& a, const Rgb& b) {
    const double scale = std::max(max_component(a), max_component(b));
    const Rgb d = a - b;
    return scale > kFewDigits ? std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)}) / scale : 0;
}

double relative_difference(double a, double b) { return relative_difference(Rgb(a), Rgb(b)); }

/// Directions whose cosines are no smaller than 0.001: the relation is exact, its conditioning is not.
bool tame(const Vec3& w) { return std::abs(w.z) > 1e-3; }

class BsdfConsistency : public testing::TestWithParam<BsdfCase> {};

TEST_P(BsdfConsistency, WeightIsEvalOverPdfAndDensitiesAreThoseOfPdf) {
    for (const Bsdf& bsdf : {flat(GetParam().model), tilted(GetParam().model)}) {
        Rng rng(2, 0, 0);
        for (int i = 0; i < kPairs; ++i) {
            const Vec3 wo = random_direction(rng);
            const TransportMode mode = kModes[i % 2];
            const std::optional<BsdfSample> sample = draw(bsdf, wo, mode, rng);
            if (!sample || sample->delta) continue;
            const Rgb expected = bsdf.eval_cos(wo, sample->wi, mode, kCorrect) / sample->pdf_fwd;
            // World directions are rotated into the frame and back: 1e-16 of noise over the width of the lobe.
            const double tolerance = 1e-10 + 1e-12 / GetParam().lobe_width;
            EXPECT_LT(relative_difference(sample->weight, expected), tolerance);
            EXPECT_LT(relative_difference(sample->pdf_fwd, bsdf.pdf(wo, sample->wi)), tolerance);
            EXPECT_LT(relative_difference(sample->pdf_rev, bsdf.pdf(sample->wi, wo)), tolerance);
        }
    }
}

/// fs(wi -> wo) / eta_o^2 = fs(wo -> wi) / eta_i^2 (theory.md §5), with the density's pairs where the lobes are.
TEST_P(BsdfConsistency, IsReciprocalUpToSquaredIndex) {
    const BsdfCase& c = GetParam();
    if (!c.symmetric) return;  // ImportanceIsTheAdjointOfRadiance is its test
    const Bsdf bsdf = flat(c.model);
    Rng rng(3, 0, 0);
    int crossing = 0;
    for (int i = 0; i < 2 * kPairs; ++i) {
        const Vec3 wo = random_direction(rng);
        const std::optional<Vec3> wi =
            i % 2 == 0 ? random_direction(rng) : sample_non_delta(bsdf, wo, TransportMode::Radiance, rng);
        if (!wi || !tame(wo) || !tame(*wi)) continue;
        const auto radiance = [&](const Vec3& known, const Vec3& sampled) {
            const double eta = eta_of(c, known);
            return bsdf.eval_cos(known, sampled, TransportMode::Radiance, kCorrect) / (std::abs(sampled.z) * eta * eta);
        };
        EXPECT_LT(relative_difference(radiance(wo, *wi), radiance(*wi, wo)), 1e-10);
        crossing += wo.z * wi->z < 0 && !is_black(radiance(wo, *wi));
    }
    if (!c.two_sided && c.lobe_width < 1 && bsdf.connectible() && c.name.find("veil") == std::string::npos) {
        EXPECT_GT(crossing, 10);
    }
}

/// f*(wo -> wi) of particles is f(wi -> wo) of radiance, known and sampled directions exchanged; the wrapper's fbar has
/// the same property with n_g's cosines taken out (theory.md §4, §6).
TEST_P(BsdfConsistency, ImportanceIsTheAdjointOfRadiance) {
    int lit = 0;
    for (const Bsdf& bsdf : {flat(GetParam().model), tilted(GetParam().model)}) {
        Rng rng(4, 0, 0);
        for (int i = 0; i < 2 * kPairs; ++i) {
            const Vec3 wo = random_direction(rng);
            const std::optional<Vec3> wi =
                i % 2 == 0 ? random_direction(rng) : sample_non_delta(bsdf, wo, TransportMode::Importance, rng);
            if (!wi || !tame(wo) || !tame(*wi)) continue;
            const Rgb particles = bsdf.eval_cos(wo, *wi, TransportMode::Importance, kCorrect) / std::abs(wi->z);
            const Rgb radiance = bsdf.eval_cos(*wi, wo, TransportMode::Radiance, kCorrect) / std::abs(wo.z);
            EXPECT_LT(relative_difference(particles, radiance), 1e-10);
            lit += !is_black(particles);
        }
    }
    if (flat(GetParam().model).connectible()) {
        EXPECT_GT(lit, kPairs / 2);
    }
}

/// The densities do not know which way light flows: both modes draw the same directions from the same numbers.
TEST_P(BsdfConsistency, BothModesSampleAlike) {
    const Bsdf bsdf = tilted(GetParam().model);
    Rng directions(5, 0, 0);
    for (int i = 0; i < kPairs; ++i) {
        const Vec3 wo = random_direction(directions);
        const auto seed = static_cast<std::uint64_t>(i);
        Rng a(6, seed, 0);
        Rng b(6, seed, 0);
        const auto radiance = draw(bsdf, wo, TransportMode::Radiance, a);
        const auto importance = draw(bsdf, wo, TransportMode::Importance, b);
        ASSERT_EQ(radiance.has_value(), importance.has_value());
        if (!radiance) continue;
        EXPECT_EQ(radiance->wi, importance->wi);
        EXPECT_EQ(radiance->pdf_fwd, importance->pdf_fwd);
        EXPECT_EQ(radiance->pdf_rev, importance->pdf_rev);
        EXPECT_EQ(radiance->radiance_scale, importance->radiance_scale);
        EXPECT_EQ(radiance->delta, importance->delta);
    }
}

/// Lobes' presence is what sampling shows.
TEST_P(BsdfConsistency, ConnectibleMeansThatALobeIsNoDelta) {
    const Bsdf bsdf = flat(GetParam().model);
    bool delta = false;
    bool non_delta = false;
    Rng rng(7, 0, 0);
    for (int i = 0; i < 3000; ++i) {
        const auto sample = draw(bsdf, random_direction(rng), TransportMode::Radiance, rng);
        if (sample) (sample->delta ? delta : non_delta) = true;
    }
    EXPECT_EQ(bsdf.connectible(), non_delta);
    EXPECT_EQ(std::visit([](const auto& m) { return m.has_delta(); }, GetParam().model), delta);
    EXPECT_EQ(std::visit([](const auto& m) { return m.has_non_delta(); }, GetParam().model), non_delta);
}

std::string test_name(const testing::TestParamInfo<BsdfCase>& info) {
    std::string name;
    for (char ch : info.param.name) name += std::isalnum(static_cast<unsigned char>(ch)) != 0 ? ch : '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(AllModels, BsdfConsistency, testing::ValuesIn(bsdf_cases()), test_name);

}  // namespace
}  // namespace etendue::test
