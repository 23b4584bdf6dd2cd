// Energy: no model reflects and transmits more than it receives, and white ones lose only masked light.

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "bsdf/fresnel.h"
#include "bsdf/microfacet_reflection.h"
#include "bsdf/specular_albedo.h"
#include "math/constants.h"
#include "support/bsdf_cases.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

/// Per channel, the share of the power arriving along wo that leaves again. Particles' weights are that share at once;
/// radiance is scaled by the squared index on crossing, which radiance_scale divides out.
std::array<Estimate, 3> albedo(const BsdfModel& model, const Vec3& wo, TransportMode mode, int count,
                               std::uint64_t seed) {
    const Bsdf bsdf = flat(model);
    Rng rng(seed, 0, 0);
    std::array<Estimate, 3> share;
    const int n = samples(count);
    for (int i = 0; i < n; ++i) {
        const double u_lobe = (i + rng.next_1d()) / n;
        const auto sample = bsdf.sample(wo, u_lobe, rng.next_2d(), mode, kCorrect);
        const double scale = sample && mode == TransportMode::Radiance ? sample->radiance_scale : 1;
        const Rgb weight = sample ? sample->weight / scale : Rgb();
        share[0].add(weight.r);
        share[1].add(weight.g);
        share[2].add(weight.b);
    }
    return share;
}

testing::AssertionResult at_most(const std::array<Estimate, 3>& share, double bound) {
    for (const Estimate& e : share) {
        if (e.mean() > bound + kSigmas * e.standard_error() + kRounding) {
            return testing::AssertionFailure() << e.mean() << " +- " << e.standard_error() << " exceeds " << bound;
        }
    }
    return testing::AssertionSuccess();
}

testing::AssertionResult at_least(const std::array<Estimate, 3>& share, double bound) {
    for (const Estimate& e : share) {
        if (e.mean() < bound - kSigmas * e.standard_error() - kRounding) {
            return testing::AssertionFailure() << e.mean() << " +- " << e.standard_error() << " is below " << bound;
        }
    }
    return testing::AssertionSuccess();
}

BsdfModel white_layered_metal(double alpha) {
    LayeredParameters p;
    p.alpha = alpha;
    p.metal = 1;
    p.metal_fresnel = {Rgb(1), Rgb(1), Rgb()};
    return Layered(p);
}

constexpr double kCosines[]{0.999, 0.8, 0.5, 0.2, 0.05, -0.05, -0.3, -0.6, -0.95};

TEST(BsdfFurnace, NeverGainsEnergy) {
    for (const BsdfCase& c : bsdf_cases()) {
        for (double cos : kCosines) {
            for (TransportMode mode : kModes) {
                if (!c.symmetric && mode == TransportMode::Importance) continue;
                EXPECT_TRUE(at_most(albedo(c.model, direction(cos, 1), mode, 4000, 11), 1))
                    << c.name << ", wo.z " << cos;
            }
        }
    }
}

TEST(BsdfFurnace, ParticlesAndRadianceCarryTheSameShare) {
    for (const BsdfCase& c : bsdf_cases()) {
        if (!c.symmetric) continue;
        for (double cos : {0.7, -0.7}) {
            const auto particles = albedo(c.model, direction(cos, 1), TransportMode::Importance, 20000, 12);
            const auto radiance = albedo(c.model, direction(cos, 1), TransportMode::Radiance, 20000, 13);
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_TRUE(agree(particles[i], radiance[i], 0.02)) << c.name << ", wo.z " << cos;
            }
        }
    }
}

/// The mean of delta lobes is a sum of two terms: R + T = 1 to rounding.
TEST(BsdfFurnace, SmoothInterfacesLoseNothing) {
    for (const BsdfCase& c : bsdf_cases()) {
        if (!c.white || flat(c.model).connectible()) continue;
        for (double cos : kCosines) {
            for (TransportMode mode : kModes) {
                const auto share = albedo(c.model, direction(cos, 1), mode, 1000, 14);
                EXPECT_TRUE(at_least(share, 1 - 1e-12)) << c.name << ", wo.z " << cos;
                EXPECT_TRUE(at_most(share, 1 + 1e-12)) << c.name << ", wo.z " << cos;
            }
        }
    }
}

/// Single scattering loses what a facet sends into another one, the more the rougher; glass seen from inside, whose
/// facets spread directions further, more than metal.
TEST(BsdfFurnace, RoughWhiteModelsLoseLittle) {
    const auto least = [](double alpha) { return alpha <= 1e-3 ? 0.985 : alpha <= 0.01 ? 0.95 : 0.84; };
    for (double cos : {0.999, 0.8, 0.5, 0.2, 0.05}) {
        const Vec3 wo = direction(cos, 2);
        for (double alpha : {1e-4, 1e-3, 0.01, 0.04, 0.09, 0.25}) {
            EXPECT_TRUE(
                at_least(albedo(Conductor(Rgb(1), alpha), wo, TransportMode::Radiance, 20000, 15), least(alpha)))
                << "metal, alpha " << alpha << ", cos " << cos;
            for (double side : {1.0, -1.0}) {
                const Vec3 w{wo.x, wo.y, side * wo.z};
                EXPECT_TRUE(at_least(albedo(Dielectric(1.5, alpha), w, TransportMode::Importance, 20000, 16),
                                     least(alpha) - (alpha > 0.1 ? 0.06 : 0)))
                    << "glass, alpha " << alpha << ", cos " << w.z;
            }
        }
    }
}

/// alpha = 1 at normal incidence by hand: D = 1 / pi and G2 = 2 cos_i / (1 + cos_i), so that the albedo of single
/// scattering is the integral of c / (1 + c) over [0, 1].
TEST(BsdfFurnace, RoughestMetalAtNormalIncidence) {
    const SpecularAlbedo single = specular_albedo(1, 1);
    EXPECT_NEAR(single.of_f0 + single.of_f90, 1 - std::log(2), 0.003);
}

/// What single scattering loses comes back, up to the margin of the table that says how much that is.
TEST(BsdfFurnace, RoughWhiteMetalLosesNothing) {
    for (double alpha : {0.04, 0.09, 0.25, 0.5, 1.0}) {
        for (double cos : {0.999, 0.8, 0.5, 0.3, 0.2, 0.05}) {
            for (const BsdfModel& model : {BsdfModel(Conductor(Rgb(1), alpha)), white_layered_metal(alpha)}) {
                const auto share = albedo(model, direction(cos, 2), TransportMode::Radiance, 40000, 23);
                EXPECT_TRUE(at_most(share, 1)) << "alpha " << alpha << ", cos " << cos;
                EXPECT_TRUE(at_least(share, cos > 0.1 ? 0.985 : 0.92)) << "alpha " << alpha << ", cos " << cos;
            }
        }
    }
}

/// Metal is the same in a Layered as alone.
TEST(BsdfFurnace, LayeredMetalIsAConductor) {
    const Vec3 wo = direction(0.4, 1);
    const Vec3 wi = direction(0.7, 3);
    for (double alpha : {0.01, 0.03, 0.5}) {
        const Rgb alone = Conductor(Rgb(1), alpha).eval(wo, wi, TransportMode::Radiance, kCorrect);
        const Rgb layered = std::visit([&](const auto& m) { return m.eval(wo, wi, TransportMode::Radiance, kCorrect); },
                                       white_layered_metal(alpha));
        EXPECT_NEAR(layered.r / alone.r, 1, 1e-12) << alpha;
    }
}

/// Colours deepen with every reflection: F^2 / (1 - F lost) of what white returns.
TEST(BsdfFurnace, ColouredMetalReturnsLess) {
    const auto white = albedo(Conductor(Rgb(1), 1), {0, 0, 1}, TransportMode::Radiance, 100000, 24);
    const auto grey =
        albedo(Conductor(SchlickFresnel{Rgb(0.5), Rgb(0.5), Rgb()}, 1), {0, 0, 1}, TransportMode::Radiance, 100000, 25);
    const double single = 1 - std::log(2);
    const double lost = mean_lost_albedo(1);
    const double factor = 0.25 * (1 - lost) / (1 - 0.5 * lost);
    EXPECT_NEAR(grey[0].mean(), 0.5 * single + factor * (white[0].mean() - single), 0.005);
}

/// A white base under a clear coat: at most a few percent are lost besides what the coat's own facets mask.
TEST(BsdfFurnace, WhitePlasticLosesLittle) {
    for (double alpha : {0.0, 1e-3, 0.04, 0.09, 0.25, 1.0}) {
        for (double cos : {0.999, 0.8, 0.5, 0.3, 0.1}) {
            LayeredParameters p;
            p.alpha = alpha;
            p.coated = 1;
            p.coat_f0 = Rgb(0.04);
            p.coat_f90 = Rgb(1);
            p.diffuse = Rgb(1);
            const auto share = albedo(Layered(p), direction(cos, 2), TransportMode::Radiance, 40000, 18);
            EXPECT_TRUE(at_most(share, 1)) << "alpha " << alpha << ", cos " << cos;
            EXPECT_TRUE(at_least(share, cos > 0.25 ? 0.985 : 0.96)) << "alpha " << alpha << ", cos " << cos;
        }
    }
}

/// The same under a clearcoat: what it does not reflect reaches the plastic, and comes back.
TEST(BsdfFurnace, WhitePlasticUnderAClearcoatLosesLittle) {
    for (double alpha : {0.0, 0.04, 0.25}) {
        for (double top_alpha : {0.0, 0.04, 0.25}) {
            for (double cos : {0.999, 0.8, 0.5, 0.3}) {
                LayeredParameters p;
                p.alpha = alpha;
                p.coated = 1;
                p.coat_f0 = Rgb(0.04);
                p.coat_f90 = Rgb(1);
                p.diffuse = Rgb(1);
                p.clearcoat = {top_alpha, 0.04, 1};
                const auto share = albedo(Layered(p), direction(cos, 2), TransportMode::Radiance, 20000, 21);
                EXPECT_TRUE(at_most(share, 1)) << "alpha " << alpha << " under " << top_alpha << ", cos " << cos;
                EXPECT_TRUE(at_least(share, 0.96)) << "alpha " << alpha << " under " << top_alpha << ", cos " << cos;
            }
        }
    }
}

/// An amount of 0 is no clearcoat at all, and small amounts come close to it.
TEST(BsdfFurnace, ClearcoatFadesOut) {
    LayeredParameters p;
    p.alpha = 0.25;
    p.coated = 1;
    p.coat_f0 = Rgb(0.04);
    p.coat_f90 = Rgb(1);
    p.diffuse = Rgb(1);
    const Vec3 wo = direction(0.6, 2);
    const Vec3 wi = direction(0.3, 4);
    const auto f = [&](double amount) {
        p.clearcoat = {0.04, 0.04 * amount, amount};
        return Layered(p).eval(wo, wi, TransportMode::Radiance, kCorrect).r;
    };
    EXPECT_NEAR(f(1e-9) / f(0), 1, 1e-3);  // less by how much Cauchy and Schwarz fall short
    EXPECT_LT(f(1), 0.95 * f(0));
}

/// Albedo by quadrature in the cosine and the azimuth, which the ridge of s / max(cos_o, cos_i) divides.
double rough_diffuse_albedo(double reflectance, double roughness, double cos) {
    constexpr int kN = 300;
    const Vec3 wo = direction(cos, 0);
    double sum = 0;
    for (int half = 0; half < 2; ++half) {
        const double c0 = half == 0 ? 0 : cos;
        const double width = half == 0 ? cos : 1 - cos;
        for (int i = 0; i < kN; ++i) {
            const double c = c0 + width * (i + 0.5) / kN;
            for (int j = 0; j < kN; ++j) {
                const Vec3 wi = direction(c, kPi * (j + 0.5) / kN);
                sum += RoughDiffuse::f(Rgb(reflectance), roughness, wo, wi).r * c * 2 * kPi * width / (kN * kN);
            }
        }
    }
    return sum;
}

/// White reflects everything at any roughness and angle; grey less than its reflectance, for more bounces cost more.
TEST(BsdfFurnace, RoughDiffusePreservesEnergy) {
    for (double roughness : {0.1, 0.5, 1.0}) {
        for (double cos : {1.0, 0.9, 0.5, 0.1, 0.01}) {
            EXPECT_NEAR(rough_diffuse_albedo(1, roughness, cos), 1, 2e-4) << roughness << ' ' << cos;
            EXPECT_LT(rough_diffuse_albedo(0.5, roughness, cos), 0.5 + 1e-4) << roughness << ' ' << cos;
        }
    }
    EXPECT_LT(rough_diffuse_albedo(0.5, 1, 1), 0.49);
}

/// Along the normal both forms of Phong have the albedo that they are named by, at any exponent. Particles that come in
/// along the normal leave the classic form with less: reflectance (n + 1) / (n + 2).
TEST(BsdfFurnace, PhongAlongTheNormal) {
    const Vec3 normal{0, 0, 1};
    for (double n : {0.0, 3.0, 50.0}) {
        const auto share = [&](PhongForm form, TransportMode mode) {
            return albedo(Phong(Rgb(0.8), n, form), normal, mode, 100000, 22)[0];
        };
        EXPECT_TRUE(agrees(share(PhongForm::Modified, TransportMode::Radiance), 0.8)) << n;
        EXPECT_TRUE(agrees(share(PhongForm::Modified, TransportMode::Importance), 0.8)) << n;
        EXPECT_TRUE(agrees(share(PhongForm::Classic, TransportMode::Radiance), 0.8)) << n;
        EXPECT_TRUE(agrees(share(PhongForm::Classic, TransportMode::Importance), 0.8 * (n + 1) / (n + 2))) << n;
    }
}

/// A smooth pane by the geometric series of its two faces: R + (1 - R)^2 R (1 + R^2 + ...), and the rest straight on.
TEST(BsdfFurnace, SmoothPaneSumsItsInternalReflections) {
    for (double cos : {0.9, 0.3, -0.6}) {
        const Vec3 wo = direction(cos, 1);
        const double r = fresnel_dielectric(std::abs(cos), 1.5);
        double series = r;
        for (int k = 1; k < 100; k += 2) series += (1 - r) * (1 - r) * std::pow(r, k);
        const Bsdf pane = flat(Dielectric(1.5, 0, Rgb(1), Rgb(0.5), true));
        const double p = series / (series + (1 - series) / 2);
        for (TransportMode mode : kModes) {
            const auto reflected = pane.sample(wo, 0, {}, mode, kCorrect);
            const auto straight = pane.sample(wo, 0.999, {}, mode, kCorrect);
            ASSERT_TRUE(reflected && straight);
            EXPECT_NEAR(reflected->weight.r * p, series, 1e-12);
            EXPECT_EQ(straight->wi, -wo);
            EXPECT_NEAR(straight->weight.r * (1 - p), 0.5 * (1 - series), 1e-12);
            EXPECT_EQ(straight->radiance_scale, 1);
        }
    }
}

/// The blur of a rough pane is that of two faces whose small slopes bend light by (ior - 1)(m1 - m2): at equal chances
/// narrower than the mirror image by |ior - 1| / sqrt(2).
TEST(BsdfFurnace, RoughPaneBlursLessThanItReflects) {
    const Bsdf pane = flat(Dielectric(1.5, 0.01, Rgb(1), Rgb(1), true));
    const Vec3 wo{0, 0, 1};
    const auto offset = [&](double u_lobe) {
        const auto s = pane.sample(wo, u_lobe, {0.5, 0.25}, TransportMode::Radiance, kCorrect);
        return std::hypot(s->wi.x, s->wi.y);
    };
    EXPECT_NEAR(offset(0.999) / offset(0), 0.5 / std::sqrt(2), 1e-3);
}

/// The bound holds for every parameter: random closures, white wherever that is worst.
TEST(BsdfFurnace, RandomClosuresNeverGainEnergy) {
    Rng rng(19, 0, 0);
    for (int i = 0; i < 400; ++i) {
        LayeredParameters p;
        const double roughness = rng.next_1d();
        p.alpha = roughness * roughness;
        double parts[4];
        double sum = 0;
        for (double& part : parts) sum += part = rng.next_1d() < 0.4 ? 0 : rng.next_1d();
        if (sum == 0) continue;
        p.presence = rng.next_1d() < 0.7 ? 1 : rng.next_1d();
        p.metal = parts[0] / sum;
        p.coated = parts[1] / sum;
        p.veil = parts[2] / sum;
        p.glass = parts[3] / sum;
        p.metal_fresnel = {Rgb(rng.next_1d()), Rgb(1), Rgb()};
        p.coat_f0 = Rgb(std::pow(rng.next_1d(), 3));
        p.coat_f90 = Rgb(1);
        p.diffuse = Rgb(1);
        if (i % 3 == 0) p.diffuse_roughness = rng.next_1d();
        p.veil_ior = p.coat_f0.r < 0.5 ? 1.5 : 0.7;
        p.glass_model = Dielectric(0.6 + 2 * rng.next_1d(), p.alpha);
        const double top = i % 2 == 0 ? 0 : rng.next_1d();
        p.clearcoat = {std::pow(rng.next_1d(), 2), top * std::pow(rng.next_1d(), 3), top};
        const double cos = 2 * rng.next_1d() - 1;
        const auto seed = 100 + static_cast<std::uint64_t>(i);
        EXPECT_TRUE(at_most(albedo(Layered(p), direction(cos, 2), TransportMode::Importance, 4000, seed), 1))
            << "alpha " << p.alpha << " metal " << p.metal << " coated " << p.coated << " veil " << p.veil << " glass "
            << p.glass << " f0 " << p.coat_f0.r << " clearcoat " << top << " cos " << cos;
    }
}

/// Albedo of a Schlick coat by a fine quadrature of its sampler.
SpecularAlbedo true_albedo(double cos, double alpha) {
    constexpr int kN = 160;
    SpecularAlbedo sum;
    const Vec3 wo = direction(cos, 0);
    const Ggx ggx(alpha);
    for (int i = 0; i < kN; ++i) {
        const double rest = 1 - (i + 0.5) / kN;  // more points where the lobe dips below the surface
        constexpr int kHalf = kN / 2;
        for (int j = 0; j < kHalf; ++j) {
            const Vec2 u{1 - rest * rest, (j + 0.5) / kN};
            const Vec3 wi = sample_microfacet_reflection(ggx, wo, u);
            if (wi.z <= 0) continue;
            const MicrofacetReflection facet(ggx, wo, wi);
            const double weight = 2 * rest / (kN * kHalf) * facet.value * wi.z / facet.pdf_fwd;
            const double s5 = pow5(std::max(0.0, 1 - facet.cos_m));
            sum.of_f0 += weight * (1 - s5);
            sum.of_f90 += weight * s5;
        }
    }
    return sum;
}

/// The table plus its margin bounds the truth, for every f0 <= f90 = 1: it is enough to look at f0 = 0 and f0 = 1.
TEST(SpecularAlbedo, MarginCoversTheTablesError) {
    Rng rng(20, 0, 0);
    for (int i = 0; i < samples(1000); ++i) {
        double cos = rng.next_1d();
        if (i % 2 == 0) cos = cos * cos * cos;
        double roughness = rng.next_1d();
        if (i % 3 == 0) roughness = roughness * roughness;
        if (i % 4 == 0) roughness = 0.003 + 0.06 * roughness;  // between smooth and the first row
        const double alpha = roughness * roughness;
        if (alpha < kSmoothAlpha || cos < 1e-6) continue;
        const SpecularAlbedo truth = true_albedo(cos, alpha);
        const SpecularAlbedo table = specular_albedo(cos, alpha);
        const double margin = specular_albedo_margin(cos, alpha);
        constexpr double kQuadrature = 1e-6;  // of the truth, where the margin is nothing
        EXPECT_LE(truth.of_f90, table.of_f90 + margin + kQuadrature) << "cos " << cos << " alpha " << alpha;
        EXPECT_LE(truth.of_f0 + truth.of_f90, table.of_f0 + table.of_f90 + margin + kQuadrature)
            << "cos " << cos << " alpha " << alpha;
        if (cos > 0.2) {
            EXPECT_NEAR(truth.of_f0 + truth.of_f90, table.of_f0 + table.of_f90, 0.004);
        }
    }
}

/// What lies under a rough layer must not grow dark when the layer ceases to be smooth.
TEST(SpecularAlbedo, GoesOverIntoTheSmoothOne) {
    const double rough = kSmoothAlpha * (1 + 1e-12);
    const double smooth = kSmoothAlpha * (1 - 1e-12);
    for (double cos : {0.0, 1e-4, 0.013, 0.1, 0.37, 0.8, 1.0}) {
        EXPECT_NEAR(specular_albedo(cos, rough).of_f0, specular_albedo(cos, smooth).of_f0, 1e-10) << cos;
        EXPECT_NEAR(specular_albedo(cos, rough).of_f90, specular_albedo(cos, smooth).of_f90, 1e-10) << cos;
        EXPECT_NEAR(specular_albedo_margin(cos, rough), 0, 1e-10) << cos;
    }
    EXPECT_NEAR(mean_specular_albedo(rough).of_f90, mean_specular_albedo(smooth).of_f90, 1e-10);
    EXPECT_NEAR(mean_squared_specular_albedo(rough).of_f0_f90, mean_squared_specular_albedo(smooth).of_f0_f90, 1e-10);
}

TEST(SpecularAlbedo, MeanIsTheIntegralOfTheDirectionalOne) {
    for (double alpha : {0.0, 1e-4, 0.01, 0.1, 0.37, 1.0}) {
        double f0 = 0;
        double f90 = 0;
        constexpr int kN = 20000;
        for (int i = 0; i < kN; ++i) {
            const double cos = (i + 0.5) / kN;
            f0 += 2 * cos * specular_albedo(cos, alpha).of_f0 / kN;
            f90 += 2 * cos * specular_albedo(cos, alpha).of_f90 / kN;
        }
        EXPECT_NEAR(mean_specular_albedo(alpha).of_f0, f0, 1e-6) << alpha;
        EXPECT_NEAR(mean_specular_albedo(alpha).of_f90, f90, 1e-6) << alpha;
    }
}

/// Bounded from below by the integral for the tabulated albedo, whatever the roughness, and close to it.
TEST(SpecularAlbedo, MeanSquareIsAtLeastTheIntegral) {
    for (double alpha : {0.0, 1e-4, 0.01, 0.1, 0.37, 1.0}) {
        for (const auto& [f0, f90] : {std::pair(0.04, 1.0), std::pair(1.0, 0.0), std::pair(0.3, 0.3)}) {
            double square = 0;
            constexpr int kN = 20000;
            for (int i = 0; i < kN; ++i) {
                const double cos = (i + 0.5) / kN;
                const double e = specular_albedo(cos, alpha)(Rgb(f0), Rgb(f90)).r;
                square += 2 * cos * e * e / kN;
            }
            const double bound = mean_squared_specular_albedo(alpha)(Rgb(f0), Rgb(f90)).r;
            EXPECT_GE(bound, square - 1e-6) << alpha;
            EXPECT_NEAR(bound, square, 2e-3) << alpha;
        }
    }
}

}  // namespace
}  // namespace etendue::test
