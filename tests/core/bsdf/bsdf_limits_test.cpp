// Where formulas divide by nearly nothing: alpha -> 0, eta -> 1, grazing angles, and whatever a fuzzer finds.

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "bsdf/fresnel.h"
#include "math/constants.h"
#include "support/bsdf_cases.h"
#include "support/invalid_operations.h"

namespace etendue::test {
namespace {

bool valid(const Rgb& c) {
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b) && c.r >= 0 && c.g >= 0 && c.b >= 0;
}

testing::AssertionResult valid(const BsdfSample& s) {
    if (!valid(s.weight)) return testing::AssertionFailure() << "weight " << s.weight.r << ' ' << s.weight.g;
    if (!(std::isfinite(s.pdf_fwd) && s.pdf_fwd > 0)) return testing::AssertionFailure() << "pdf_fwd " << s.pdf_fwd;
    if (!(std::isfinite(s.pdf_rev) && s.pdf_rev >= 0)) return testing::AssertionFailure() << "pdf_rev " << s.pdf_rev;
    if (!(std::abs(length(s.wi) - 1) < 1e-9)) return testing::AssertionFailure() << "length " << length(s.wi);
    if (!(s.radiance_scale > 0)) return testing::AssertionFailure() << "radiance_scale " << s.radiance_scale;
    return testing::AssertionSuccess();
}

/// One of a few values that hurt, or any.
double nasty_fraction(Rng& rng) {
    constexpr double kValues[]{0, 1e-300, 1e-12, 1e-6, 1e-3, 0.5, 1 - 1e-9, 1};
    const auto i = static_cast<std::size_t>(rng.next_1d() * 16);
    return i < std::size(kValues) ? kValues[i] : rng.next_1d();
}

double nasty_ior(Rng& rng) {
    constexpr double kValues[]{1, 1 + 1e-15, 1 - 1e-15, 1 + 1e-9, 1.00001, 1.00002, 0.9999, 1e-3, 1e3, 1.5, 2.4, 0.4};
    const auto i = static_cast<std::size_t>(rng.next_1d() * 24);
    return i < std::size(kValues) ? kValues[i] : 0.3 + 3 * rng.next_1d();
}

Vec3 nasty_direction(Rng& rng) {
    constexpr double kValues[]{1, -1, 0, -0.0, 1e-300, -1e-300, 1e-12, -1e-12, 1e-6, 1.7e-5, -1.7e-5, 0.7453559925};
    const auto i = static_cast<std::size_t>(rng.next_1d() * 24);
    return direction(i < std::size(kValues) ? kValues[i] : 2 * rng.next_1d() - 1, 2 * kPi * rng.next_1d());
}

Rgb nasty_color(Rng& rng) { return {nasty_fraction(rng), nasty_fraction(rng), nasty_fraction(rng)}; }

BsdfModel nasty_model(Rng& rng) {
    const double roughness = nasty_fraction(rng);
    const double alpha = roughness * roughness;
    const double which = rng.next_1d();
    if (which < 0.03) return Diffuse(nasty_color(rng));
    if (which < 0.06) return RoughDiffuse(nasty_color(rng), nasty_fraction(rng));
    if (which < 0.1) {
        const double exponent = 1e8 * std::pow(nasty_fraction(rng), 4);
        return Phong(nasty_color(rng), exponent, which < 0.08 ? PhongForm::Modified : PhongForm::Classic);
    }
    if (which < 0.2) return Conductor(SchlickFresnel{nasty_color(rng), nasty_color(rng), nasty_color(rng)}, alpha);
    const bool thin = rng.next_1d() < 0.3;
    const Dielectric glass(nasty_ior(rng), alpha, nasty_color(rng), nasty_color(rng), thin);
    if (which < 0.5) return glass;
    LayeredParameters p;
    p.presence = nasty_fraction(rng);
    p.alpha = alpha;
    p.metal = nasty_fraction(rng);
    p.coated = (1 - p.metal) * nasty_fraction(rng);
    p.veil = (1 - p.metal - p.coated) * nasty_fraction(rng);
    p.glass = 1 - p.metal - p.coated - p.veil;
    p.metal_fresnel = {nasty_color(rng), nasty_color(rng), nasty_color(rng)};
    p.coat_f0 = nasty_color(rng);
    p.coat_f90 = Rgb(1);
    p.coat_tint = nasty_color(rng);
    p.diffuse = nasty_color(rng);
    if (which < 0.7) p.diffuse_roughness = nasty_fraction(rng);
    p.veil_ior = nasty_ior(rng);
    p.glass_model = glass;
    const double amount = nasty_fraction(rng);
    if (which < 0.8) p.clearcoat = {nasty_fraction(rng), amount * nasty_fraction(rng), amount};
    return Layered(p);
}

TEST(BsdfLimits, NothingButValidNumbers) {
    constexpr double kU[]{0, 0x1p-53, 0.5, kOneMinusEpsilon};
    Rng rng(41, 0, 0);
    int drawn = 0;
    for (int i = 0; i < 200000; ++i) {
        const BsdfModel model = nasty_model(rng);
        const Bsdf bsdf =
            i % 2 == 0 ? flat(model) : Bsdf(model, Frame::from_normal(nasty_direction(rng)), nasty_direction(rng));
        const TransportMode mode = kModes[i / 2 % 2];
        const Vec3 wo = nasty_direction(rng);
        const Vec3 wi = i % 5 == 0 ? -wo : nasty_direction(rng);
        EXPECT_TRUE(valid(bsdf.eval_cos(wo, wi, mode, kCorrect))) << i;
        const double pdf = bsdf.pdf(wo, wi);
        EXPECT_TRUE(std::isfinite(pdf) && pdf >= 0) << i << ' ' << pdf;
        const auto number = [&] {
            const auto j = static_cast<std::size_t>(rng.next_1d() * 8);
            return j < std::size(kU) ? kU[j] : rng.next_1d();
        };
        const double u_lobe = number();
        const double u = number();
        const auto sample = bsdf.sample(wo, u_lobe, {u, number()}, mode, kCorrect);
        if (!sample) continue;
        ++drawn;
        EXPECT_TRUE(valid(*sample)) << i;
        EXPECT_TRUE(valid(bsdf.eval_cos(wo, sample->wi, mode, kCorrect))) << i;
        EXPECT_TRUE(std::isfinite(bsdf.pdf(sample->wi, wo))) << i;
    }
    EXPECT_GT(drawn, 60000);
}

/// The smallest numbers have no reciprocal by which lobes could be made to share what they reflect.
TEST(BsdfLimits, LayersOfDenormalAlbedoAreBlack) {
    LayeredParameters p;
    p.coated = 1;
    p.diffuse = Rgb(5e-324);
    const Bsdf bsdf = flat(Layered(p));
    const Vec3 wo = direction(0.7, 0);
    std::optional<BsdfSample> sample;
    EXPECT_FALSE(raises_invalid([&] { sample = bsdf.sample(wo, 0.5, {0.3, 0.6}, TransportMode::Radiance, kCorrect); }));
    EXPECT_FALSE(sample);
}

/// Roughness 0 is Lambert to rounding, and small roughness is near it.
TEST(BsdfLimits, DiffuseRoughnessTendsToLambert) {
    const Rgb color{0.9, 0.5, 0.1};
    Rng rng(46, 0, 0);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 wo = direction(0.05 + 0.95 * rng.next_1d(), 1);
        const Vec3 wi = direction(0.05 + 0.95 * rng.next_1d(), 7 * rng.next_1d());
        const Rgb lambert = flat(Diffuse(color)).eval_cos(wo, wi, TransportMode::Radiance, kCorrect);
        for (double roughness : {0.0, 1e-6}) {
            const Rgb f = flat(RoughDiffuse(color, roughness)).eval_cos(wo, wi, TransportMode::Radiance, kCorrect);
            EXPECT_NEAR(f.r / lambert.r, 1, 1e-14 + 30 * roughness);
            EXPECT_NEAR(f.b / lambert.b, 1, 1e-14 + 30 * roughness);
        }
    }
}

/// Narrow GGX lobes tend to the smooth interface: same directions, same weights, same chances.
TEST(BsdfLimits, SmallAlphaTendsToSmooth) {
    const double alpha = 2 * kSmoothAlpha;
    const std::vector<std::pair<BsdfModel, BsdfModel>> pairs{
        {Dielectric(1.5, 0), Dielectric(1.5, alpha)},
        {Dielectric(0.7, 0), Dielectric(0.7, alpha)},
        {Conductor({0.9, 0.5, 0.3}, 0), Conductor({0.9, 0.5, 0.3}, alpha)},
    };
    for (const auto& [smooth, rough] : pairs) {
        Rng rng(42, 0, 0);
        for (int i = 0; i < 2000; ++i) {
            const Vec3 wo = direction(0.1 + 0.9 * rng.next_1d(), 1);
            const double u_lobe = rng.next_1d();
            const Vec2 u{0.9 * rng.next_1d(), rng.next_1d()};  // without the far tail
            const auto a = flat(smooth).sample(wo, u_lobe, u, TransportMode::Radiance, kCorrect);
            const auto b = flat(rough).sample(wo, u_lobe, u, TransportMode::Radiance, kCorrect);
            ASSERT_TRUE(a && b);
            if (a->transmission != b->transmission) continue;  // u_lobe within 1e-4 of the Fresnel reflectance
            EXPECT_LT(length(a->wi - b->wi), 2e-3);
            EXPECT_NEAR(a->weight.r / b->weight.r, 1, 1e-3);
        }
    }
}

TEST(BsdfLimits, IndexTendsToOne) {
    const Vec3 wo = direction(0.3, 1);
    for (double difference : {1e-3, 1e-4, 2e-5, 1e-6, 1e-9, 0.0}) {
        for (double alpha : {0.0, 0.25}) {
            for (double ior : {1 + difference, 1 - difference}) {
                for (double u_lobe : {0.3, 0.9}) {
                    const auto s =
                        flat(Dielectric(ior, alpha)).sample(wo, u_lobe, {0.3, 0.7}, TransportMode::Radiance, kCorrect);
                    ASSERT_TRUE(s && s->transmission);
                    EXPECT_LT(length(s->wi + wo), 20 * difference + 1e-15);
                    // Masking by facets does not vanish with the index.
                    EXPECT_NEAR(s->weight.r, 1, (alpha > 0 ? 0.15 : 0.01) + 4 * difference);
                }
            }
        }
    }
    // Index 1 is no surface at all, smooth or rough.
    const auto s = flat(Dielectric(1, 0.25)).sample(wo, 0, {0.3, 0.7}, TransportMode::Importance, kCorrect);
    ASSERT_TRUE(s);
    EXPECT_EQ(s->wi, -wo);
    EXPECT_EQ(s->weight, Rgb(1));
    EXPECT_TRUE(s->delta);
}

/// A pane whose index is that of the air is not there, rough or not, and nearly so when it nearly is.
TEST(BsdfLimits, PaneVanishesWithItsIndex) {
    for (double difference : {1e-3, 1e-6, 0.0}) {
        for (double alpha : {0.0, 0.25}) {
            const Bsdf pane = flat(Dielectric(1 + difference, alpha, Rgb(1), Rgb(1), true));
            const auto s = pane.sample(direction(0.6, 1), 0.9, {0.3, 0.7}, TransportMode::Radiance, kCorrect);
            ASSERT_TRUE(s && s->transmission);
            EXPECT_LE(length(s->wi + direction(0.6, 1)), difference);
            EXPECT_NEAR(s->weight.r, 1, 0.01);
        }
    }
}

TEST(BsdfLimits, GrazingAngles) {
    const double cos = std::cos(89.999 * kPi / 180);
    Rng rng(43, 0, 0);
    for (const BsdfCase& c : bsdf_cases()) {
        for (double side : {1.0, -1.0}) {
            int valid_samples = 0;
            for (int i = 0; i < 2000; ++i) {
                const TransportMode mode = c.symmetric ? kModes[i % 2] : TransportMode::Radiance;
                const auto s = draw(flat(c.model), direction(side * cos, 1), mode, rng);
                if (!s) continue;
                ++valid_samples;
                ASSERT_TRUE(valid(*s)) << c.name;
                EXPECT_LT(max_component(s->weight), 20) << c.name;
            }
            EXPECT_GT(valid_samples, 100) << c.name;
        }
    }
}

/// Light grazing a smooth surface is reflected; seen the other way round too.
TEST(BsdfLimits, GrazingLightIsReflected) {
    const Vec3 wo = direction(std::cos(89.999 * kPi / 180), 1);
    const auto s = flat(Dielectric(1.5, 0)).sample(wo, 0.999, {}, TransportMode::Radiance, kCorrect);
    ASSERT_TRUE(s);
    EXPECT_FALSE(s->transmission);
}

TEST(Fresnel, KnownValues) {
    EXPECT_NEAR(fresnel_dielectric(1, 1.5), 0.04, 1e-16);
    EXPECT_NEAR(fresnel_dielectric(1, 1 / 1.5), 0.04, 1e-16);
    EXPECT_EQ(fresnel_dielectric(0, 1.5), 1);
    EXPECT_EQ(fresnel_dielectric(0.7, 1 / 1.5), 1);  // beyond the critical angle, cos 0.745
    EXPECT_EQ(fresnel_dielectric(0.2, 1), 0);
    // Brewster's angle: tan = eta; only s-polarised light is reflected, r_s = (1 - eta^2) / (1 + eta^2).
    const double eta = 1.5;
    const double r_s = (1 - eta * eta) / (1 + eta * eta);
    EXPECT_NEAR(fresnel_dielectric(1 / std::sqrt(1 + eta * eta), eta), r_s * r_s / 2, 1e-15);
}

/// Against the textbook formula in extended precision, next to eta = 1 and to the critical angle.
TEST(Fresnel, KeepsItsDigits) {
    const auto textbook = [](long double c, long double eta) {
        const long double ct = std::sqrt(1 - (1 - c * c) / (eta * eta));
        const long double rs = (c - eta * ct) / (c + eta * ct);
        const long double rp = (eta * c - ct) / (eta * c + ct);
        return static_cast<double>((rs * rs + rp * rp) / 2);
    };
    Rng rng(44, 0, 0);
    for (int i = 0; i < 20000; ++i) {
        const double c = rng.next_1d();
        const double eta = i % 2 == 0 ? 1 + std::pow(10, -3 * rng.next_1d()) : 1 + 2 * rng.next_1d();
        EXPECT_NEAR(fresnel_dielectric(c, eta) / textbook(c, eta), 1, 1e-9) << c << ' ' << eta;
    }
    for (double eta : {1 / 1.5, 1 / 1.0001}) {
        const double critical = std::sqrt((1 - eta) * (1 + eta));
        EXPECT_EQ(fresnel_dielectric(critical * (1 - 1e-12), eta), 1);
        EXPECT_GT(fresnel_dielectric(critical * (1 + 1e-12), eta), 0.99999);
    }
}

TEST(Fresnel, MeanIsTheIntegral) {
    for (double eta : {1.0, 1 + 2e-5, 1 + 2e-4, 1.01, 1.5, 3.0, 0.9999, 0.99, 0.7, 0.2}) {
        double sum = 0;
        constexpr int kN = 400000;
        for (int i = 0; i < kN; ++i) {
            const double x = (i + 0.5) / kN;
            const double cos = x * x;  // more points where the curve is steep
            sum += 2 * cos * fresnel_dielectric(cos, eta) * 2 * x / kN;
        }
        EXPECT_NEAR(mean_fresnel_dielectric(eta), sum, 1e-7 + 1e-2 * std::min(sum, 1e-3)) << eta;
    }
}

TEST(Fresnel, IsTheSameFromBothSides) {
    Rng rng(45, 0, 0);
    for (int i = 0; i < 10000; ++i) {
        const double c = rng.next_1d();
        const double eta = i % 2 == 0 ? 1.5 : 1 + 1e-4 * rng.next_1d();
        const double ct = refracted_cos(c, eta);
        EXPECT_EQ(fresnel_crossing(c, 1, ct, eta), fresnel_crossing(ct, eta, c, 1));
        EXPECT_NEAR(fresnel_dielectric(c, eta), fresnel_dielectric(ct, 1 / eta), 1e-10);
    }
}

/// The projected area of the facets is that of the plane: the integral of D cos over the hemisphere is 1, at any alpha.
TEST(GgxDistribution, ProjectsToOne) {
    for (double alpha : {1e-7, 1e-5, 1e-3, 0.1, 1.0}) {
        // In x = tan / alpha, D cos domega = 2 x / (1 + x^2)^2 dx; here from D itself, x = y / (1 - y).
        double sum = 0;
        constexpr int kN = 20000;
        for (int i = 0; i < kN; ++i) {
            const double y = (i + 0.5) / kN;
            const double x = y / (1 - y);
            const Vec3 h{alpha * x, 0, 1};
            const double cos = 1 / length(h);
            const double domega = 2 * kPi * alpha * alpha * x * std::pow(cos, 3) / ((1 - y) * (1 - y) * kN);
            sum += Ggx(alpha).d(h) * cos * domega;
        }
        EXPECT_NEAR(sum, 1, 1e-6) << alpha;
    }
}

/// And so is that of the visible ones, weighed by G1, seen from anywhere.
TEST(GgxDistribution, VisibleNormalsProjectToTheViewer) {
    for (double alpha : {1e-6, 1e-3, 0.25, 1.0}) {
        for (double cos : {1.0, 0.5, 0.01}) {
            const Ggx ggx(alpha);
            const Vec3 w = direction(cos, 0);
            double sum = 0;
            constexpr int kN = 800;
            for (int i = 0; i < kN; ++i) {
                const double y = (i + 0.5) / kN;
                const double x = y / (1 - y);
                for (int j = 0; j < kN; ++j) {
                    const double phi = 2 * kPi * (j + 0.5) / kN;
                    const Vec3 h{alpha * x * std::cos(phi), alpha * x * std::sin(phi), 1};
                    const double cos_m = 1 / length(h);
                    const double domega =
                        2 * kPi / kN * alpha * alpha * x * std::pow(cos_m, 3) / ((1 - y) * (1 - y) * kN);
                    const double facing = std::max(0.0, dot(w, h) * cos_m);
                    sum += ggx.d(h) * Ggx::g1_over_cos(w.z, ggx.a(w)) * facing * domega;
                }
            }
            EXPECT_NEAR(sum, 1, 2e-3) << alpha << ' ' << cos;
        }
    }
}

}  // namespace
}  // namespace etendue::test
