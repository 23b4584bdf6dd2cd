// The two asymmetries (theory.md §5, §6): right by default, and wrong by exactly the predicted factor when switched
// off. What delta lobes report as densities (transport.md §1).

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "math/constants.h"
#include "support/bsdf_cases.h"

namespace etendue::test {
namespace {

constexpr AdjointPolicy kNoRefraction{.refraction = false, .shading_normal = true};
constexpr AdjointPolicy kNoShadingNormal{.refraction = true, .shading_normal = false};

double ratio(const Rgb& a, const Rgb& b) { return max_component(a) / max_component(b); }

bool inconsistent(const Bsdf& bsdf, const Vec3& w) { return dot(w, bsdf.n_s()) * w.z <= 0; }

TEST(ShadingNormal, DirectionsOnOppositeSidesCarryNothing) {
    for (const BsdfCase& c : bsdf_cases()) {
        const Bsdf bsdf = tilted(c.model);
        Rng rng(31, 0, 0);
        int seen = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vec3 wo = random_direction(rng);
            const Vec3 wi = random_direction(rng);
            const auto sample = draw(bsdf, wo, kModes[i % 2], rng);
            if (sample && !(sample->wi == -wo)) {
                EXPECT_FALSE(inconsistent(bsdf, wo) || inconsistent(bsdf, sample->wi)) << c.name;
            }
            if (!inconsistent(bsdf, wo) && !inconsistent(bsdf, wi)) continue;
            ++seen;
            EXPECT_TRUE(is_black(bsdf.eval_cos(wo, wi, kModes[i % 2], kCorrect)));
            EXPECT_EQ(bsdf.pdf(wo, wi), 0);
        }
        EXPECT_GT(seen, 100);
    }
}

/// In theory.md's words: particles arrive along wo and leave along wi, wrong / right = |wo.Ng| |wi.Ns| / (|wo.Ns|
/// |wi.Ng|).
double predicted_wrong_over_right(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi) {
    return std::abs(wo.z) * abs_dot(wi, bsdf.n_s()) / (abs_dot(wo, bsdf.n_s()) * std::abs(wi.z));
}

TEST(ShadingNormal, LeavingTheFactorOutIsWrongByThePredictedRatio) {
    int checked_eval = 0;
    int checked_sample = 0;
    for (const BsdfCase& c : bsdf_cases()) {
        const Bsdf bsdf = tilted(c.model);
        for (std::uint64_t i = 0; i < 500; ++i) {
            Rng rng(32, i, 0);
            const Vec3 wo = random_direction(rng);
            const Vec3 wi = random_direction(rng);
            const auto eval = [&](TransportMode mode, const AdjointPolicy& policy) {
                return bsdf.eval_cos(wo, wi, mode, policy);
            };
            const Rgb right = eval(TransportMode::Importance, kCorrect);
            if (max_component(right) > kFewDigits) {
                ++checked_eval;
                EXPECT_NEAR(ratio(eval(TransportMode::Importance, kNoShadingNormal), right) /
                                predicted_wrong_over_right(bsdf, wo, wi),
                            1, 1e-12)
                    << c.name;
            }
            EXPECT_EQ(eval(TransportMode::Radiance, kNoShadingNormal), eval(TransportMode::Radiance, kCorrect));

            Rng a(33, i, 0);
            Rng b(33, i, 0);
            const auto good = draw(bsdf, wo, TransportMode::Importance, a);
            const auto bad = draw(bsdf, wo, TransportMode::Importance, b, kNoShadingNormal);
            ASSERT_EQ(good.has_value(), bad.has_value());
            if (!good) continue;
            ++checked_sample;
            EXPECT_EQ(good->wi, bad->wi);
            EXPECT_EQ(good->pdf_fwd, bad->pdf_fwd);
            EXPECT_NEAR(ratio(bad->weight, good->weight) / predicted_wrong_over_right(bsdf, wo, good->wi), 1, 1e-10)
                << c.name;
        }
    }
    EXPECT_GT(checked_eval, 1000);
    EXPECT_GT(checked_sample, 1000);
}

/// A mirror under a tilted normal, by hand: |wo.Ns| = |wi.Ns|, so particles are weighed by |wi.Ng| / |wo.Ng|.
TEST(ShadingNormal, ParticlesOffATiltedMirror) {
    const Bsdf bsdf = tilted(Conductor(Rgb(1), 0));
    const Vec3 wo = direction(0.6, 0.4);
    Rng rng(34, 0, 0);
    const auto particles = draw(bsdf, wo, TransportMode::Importance, rng);
    const auto radiance = draw(bsdf, wo, TransportMode::Radiance, rng);
    ASSERT_TRUE(particles && radiance);
    EXPECT_NEAR(particles->weight.r, particles->wi.z / wo.z, 1e-14);
    EXPECT_NEAR(radiance->weight.r, 1, 1e-14);
}

constexpr AdjointPolicy kNoPhong{.refraction = true, .shading_normal = true, .phong = false};

/// fs(wi -> wo) = Cr cos^n / |wi.N| by hand, with light coming from wi; for particles wo is where it comes from.
TEST(ClassicPhong, DividesByTheCosineOfTheIncomingDirection) {
    const Bsdf bsdf = flat(Phong(Rgb(0.6), 4, PhongForm::Classic));
    const Vec3 wo = direction(0.3, 0);
    const Vec3 wi = direction(0.8, kPi + 0.4);
    const double lobe = 0.6 * 5 / (2 * kPi) * std::pow(dot({-wo.x, -wo.y, wo.z}, wi), 4);
    const auto f = [&](TransportMode mode, const AdjointPolicy& policy) {
        return bsdf.eval_cos(wo, wi, mode, policy).r / wi.z;
    };
    EXPECT_NEAR(f(TransportMode::Radiance, kCorrect), lobe / 0.8, 1e-14);
    EXPECT_NEAR(f(TransportMode::Importance, kCorrect), lobe / 0.3, 1e-14);
    EXPECT_NEAR(f(TransportMode::Radiance, kNoPhong), lobe / 0.8, 1e-14);
    EXPECT_NEAR(f(TransportMode::Importance, kNoPhong), lobe / 0.8, 1e-14);
}

/// The switch reaches samples too, and nothing but the classic form.
TEST(ClassicPhong, LeavingTheAdjointOutIsWrongByThePredictedRatio) {
    int checked = 0;
    for (const BsdfCase& c : bsdf_cases()) {
        const Bsdf bsdf = tilted(c.model);
        for (std::uint64_t i = 0; i < 200; ++i) {
            Rng rng(37, i, 0);
            const Vec3 wo = random_direction(rng);
            Rng a(38, i, 0);
            Rng b(38, i, 0);
            const auto right = draw(bsdf, wo, TransportMode::Importance, a);
            const auto wrong = draw(bsdf, wo, TransportMode::Importance, b, kNoPhong);
            ASSERT_EQ(right.has_value(), wrong.has_value());
            if (!right) continue;
            const double predicted = c.symmetric ? 1 : abs_dot(wo, bsdf.n_s()) / abs_dot(right->wi, bsdf.n_s());
            EXPECT_NEAR(ratio(wrong->weight, right->weight) / predicted, 1, 1e-10) << c.name;
            checked += !c.symmetric;
        }
    }
    EXPECT_GT(checked, 50);
}

TEST(Refraction, ScalingParticlesLikeRadianceIsWrongBySquaredIndex) {
    int checked = 0;
    for (const BsdfCase& c : bsdf_cases()) {
        const Bsdf bsdf = flat(c.model);
        for (std::uint64_t i = 0; i < 400; ++i) {
            Rng rng(35, i, 0);
            const Vec3 wo = random_direction(rng);
            Rng a(36, i, 0);
            Rng b(36, i, 0);
            const auto right = draw(bsdf, wo, TransportMode::Importance, a);
            const auto wrong = draw(bsdf, wo, TransportMode::Importance, b, kNoRefraction);
            ASSERT_EQ(right.has_value(), wrong.has_value());
            if (!right) continue;
            const bool hole = right->delta && right->wi == -wo;
            // (eta_t / eta_i)^2 along the particles' way, which is from wo to wi.
            const double eta = hole ? 1 : eta_of(c, right->wi) / eta_of(c, wo);
            EXPECT_NEAR(ratio(wrong->weight, right->weight), eta * eta, 1e-12 * eta * eta) << c.name;
            EXPECT_NEAR(right->radiance_scale, 1 / (eta * eta), 1e-12 / (eta * eta)) << c.name;
            EXPECT_EQ(right->transmission, wo.z * right->wi.z < 0) << c.name;
            checked += right->transmission && eta != 1;
            if (right->delta) continue;
            EXPECT_NEAR(ratio(bsdf.eval_cos(wo, right->wi, TransportMode::Importance, kNoRefraction),
                              bsdf.eval_cos(wo, right->wi, TransportMode::Importance, kCorrect)),
                        eta * eta, 1e-12 * eta * eta)
                << c.name;
        }
    }
    EXPECT_GT(checked, 1000);
}

/// Radiance that enters a denser body: (1 - F) (eta_known / eta_sampled)^2, by hand at normal incidence on water.
TEST(Refraction, LookingIntoWaterAndOut) {
    const Bsdf water = flat(Dielectric(1.333, 0));
    const AdjointPolicy policy;
    const auto in = water.sample({0, 0, 1}, 0.9, {}, TransportMode::Radiance, policy);
    const auto out = water.sample({0, 0, -1}, 0.9, {}, TransportMode::Radiance, policy);
    const auto particle = water.sample({0, 0, 1}, 0.9, {}, TransportMode::Importance, policy);
    ASSERT_TRUE(in && out && particle);
    EXPECT_NEAR(in->weight.r, 1 / (1.333 * 1.333), 1e-14);
    EXPECT_NEAR(out->weight.r, 1.333 * 1.333, 1e-14);
    EXPECT_NEAR(particle->weight.r, 1, 1e-14);
}

/// Solid angle about the sampled direction per solid angle about wo, from finite differences of the map that the same
/// random numbers give.
double jacobian(const Bsdf& bsdf, const Vec3& wo, double u_lobe) {
    constexpr double kStep = 1e-5;
    const Frame frame = Frame::from_normal(wo);
    const auto map = [&](const Vec3& offset) {
        return bsdf.sample(normalize(wo + offset * kStep), u_lobe, {0.5, 0.5}, TransportMode::Radiance, kCorrect)->wi;
    };
    const Vec3 ds = (map(frame.s) - map(-frame.s)) / (2 * kStep);
    const Vec3 dt = (map(frame.t) - map(-frame.t)) / (2 * kStep);
    return length(cross(ds, dt));
}

/// A delta lobe's densities are those of a beam: over a small cone about wo, pdf_rev / pdf_fwd is the ratio of the
/// solid angles after and before, with the probabilities of choosing the lobe either way.
TEST(DeltaLobes, RatioOfDensitiesIsTheJacobianOfTheMap) {
    int refractions = 0;
    for (const BsdfCase& c : bsdf_cases()) {
        for (const Bsdf& bsdf : {flat(c.model), tilted(c.model)}) {
            for (double cos : {0.95, 0.5, -0.8, -0.95}) {
                const Vec3 wo = direction(cos, 0.3);
                for (double u_lobe : {0.001, 0.05, 0.2, 0.4, 0.6, 0.8, 0.99}) {
                    const auto s = bsdf.sample(wo, u_lobe, {0.5, 0.5}, TransportMode::Radiance, kCorrect);
                    if (!s || !s->delta) continue;
                    const bool straight = s->wi == -wo;
                    const Vec3 n = bsdf.n_s();
                    const double eta_o = straight ? 1 : eta_of(c, {0, 0, dot(wo, n)});
                    const double eta_i = straight ? 1 : eta_of(c, {0, 0, dot(s->wi, n)});
                    const double p_fwd = s->pdf_fwd / (eta_i * eta_i * abs_dot(s->wi, n));
                    const double p_rev = s->pdf_rev / (eta_o * eta_o * abs_dot(wo, n));
                    EXPECT_GT(p_fwd, 0);
                    EXPECT_LE(p_fwd, 1 + 1e-12);
                    EXPECT_NEAR((s->pdf_rev / p_rev) / (s->pdf_fwd / p_fwd) / jacobian(bsdf, wo, u_lobe), 1, 1e-6)
                        << c.name << ", wo.z " << cos << ", u " << u_lobe;
                    refractions += s->transmission && !straight;
                }
            }
        }
    }
    EXPECT_GT(refractions, 50);
}

/// The reverse density is what sampling from the other end reports, and the probability is how often the lobe comes up.
TEST(DeltaLobes, ReverseDensityIsTheForwardOneOfTheWayBack) {
    for (const BsdfCase& c : bsdf_cases()) {
        const Bsdf bsdf = flat(c.model);
        for (double cos : {0.95, 0.5, -0.8, -0.95}) {
            const Vec3 wo = direction(cos, 0.3);
            for (double u_lobe : {0.001, 0.05, 0.2, 0.4, 0.6, 0.8, 0.99}) {
                const auto s = bsdf.sample(wo, u_lobe, {0.5, 0.5}, TransportMode::Radiance, kCorrect);
                if (!s || !s->delta) continue;
                bool found = false;
                for (int i = 0; i < 1000 && !found; ++i) {
                    const auto back =
                        bsdf.sample(s->wi, (i + 0.5) / 1000, {0.5, 0.5}, TransportMode::Radiance, kCorrect);
                    if (!back || !back->delta || length(back->wi - wo) > 1e-9) continue;
                    // A straight hole and an interface of index 1 give the same direction: ask for the same lobe.
                    if (std::abs(back->pdf_fwd / s->pdf_rev - 1) > 1e-9) continue;
                    EXPECT_NEAR(back->pdf_rev, s->pdf_fwd, 1e-9 * s->pdf_fwd) << c.name;
                    found = true;
                }
                EXPECT_TRUE(found) << c.name << ", wo.z " << cos << ", u " << u_lobe;
            }
        }
    }
}

TEST(DeltaLobes, ProbabilityIsTheShareOfSamples) {
    constexpr int kN = 20000;
    for (const BsdfCase& c : bsdf_cases()) {
        const Bsdf bsdf = flat(c.model);
        for (double cos : {0.6, -0.9}) {
            const Vec3 wo = direction(cos, 0.3);
            // One direction per delta lobe, except where a hole is straight too: then the lobes' pdfs differ.
            struct Lobe {
                double pdf;
                double probability;
                int count;
            };
            std::vector<Lobe> lobes;
            for (int i = 0; i < kN; ++i) {
                const auto s = bsdf.sample(wo, (i + 0.5) / kN, {0.5, 0.5}, TransportMode::Radiance, kCorrect);
                if (!s || !s->delta) continue;
                const double eta = s->wi == -wo ? 1 : eta_of(c, s->wi);
                const double p = s->pdf_fwd / (eta * eta * std::abs(s->wi.z));
                auto it = lobes.begin();
                while (it != lobes.end() && it->pdf != s->pdf_fwd) ++it;
                if (it == lobes.end()) it = lobes.insert(it, {s->pdf_fwd, p, 0});
                ++it->count;
            }
            for (const Lobe& lobe : lobes) {
                EXPECT_NEAR(lobe.count, lobe.probability * kN, 2) << c.name << ", wo.z " << cos;
            }
        }
    }
}

}  // namespace
}  // namespace etendue::test
