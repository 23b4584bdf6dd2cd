// Every model's sampler against its density, through the wrapper, in both modes, seen from both sides.

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "support/bsdf_cases.h"
#include "support/chi2.h"

namespace etendue::test {
namespace {

/// Fewer than the tests there are would raise false alarms too often; more only loses a little sharpness.
constexpr int kTestsAtMost = 500;
constexpr double kSuiteRate = 1e-4;

/// Refraction at a plane, or nothing.
std::optional<Vec3> refracted(const Vec3& wo, double eta) {
    const double sin2 = eta * eta * (wo.x * wo.x + wo.y * wo.y);
    if (sin2 >= 1) return std::nullopt;
    return Vec3{-eta * wo.x, -eta * wo.y, -std::copysign(std::sqrt(1 - sin2), wo.z)};
}

enum class Side { Both, Reflection, Transmission };

/// One test: a sampler, its density, and where to look closely.
struct Look {
    std::string name;
    Bsdf bsdf;
    Vec3 wo;
    TransportMode mode;
    Side side = Side::Both;  ///< directions on the other side count as refused
    SphereGrid grid;
};

bool counted(const Look& look, const Vec3& wi) {
    if (look.side == Side::Both) return true;
    return (look.wo.z * wi.z > 0) == (look.side == Side::Reflection);
}

int tests_run = 0;

void run(const Look& look) {
    const auto sampler = [&](Rng& rng) -> std::optional<Vec3> {
        const std::optional<Vec3> wi = sample_non_delta(look.bsdf, look.wo, look.mode, rng);
        return wi && counted(look, *wi) ? wi : std::nullopt;
    };
    const auto density = [&](const Vec3& wi) { return counted(look, wi) ? look.bsdf.pdf(look.wo, wi) : 0; };
    const Chi2Settings settings{100000, sidak(kSuiteRate, kTestsAtMost), static_cast<std::uint64_t>(++tests_run)};
    const bool importance = look.mode == TransportMode::Importance;
    EXPECT_TRUE(passes(chi2_sphere(sampler, density, look.grid, settings)))
        << look.name << ", wo.z " << look.wo.z << (importance ? ", importance" : ", radiance")
        << (look.side == Side::Both         ? ""
            : look.side == Side::Reflection ? ", reflection"
                                            : ", transmission");
}

/// Narrow lobes are looked at one by one, with rings round their peaks.
void run_all_lobes(const BsdfCase& c, const Vec3& wo, TransportMode mode) {
    Look look{c.name, flat(c.model), wo, mode, Side::Both, {}};
    if (c.lobe_width > 0.05) return run(look);
    look.side = Side::Reflection;
    look.grid = narrow_grid({-wo.x, -wo.y, wo.z}, c.lobe_width);
    run(look);
    const double eta = eta_of(c, wo) / eta_of(c, -wo);
    const std::optional<Vec3> wt = refracted(wo, eta);
    if (c.two_sided || !wt) return;
    look.side = Side::Transmission;
    look.grid = narrow_grid(*wt, c.lobe_width);
    run(look);
}

TEST(BsdfSampling, DensityIsThatOfTheSamples) {
    for (const BsdfCase& c : bsdf_cases()) {
        if (!flat(c.model).connectible()) continue;
        for (double cos : {0.9, 0.3, 0.02, -0.95, -0.4}) {
            run_all_lobes(c, direction(cos, 0.7), TransportMode::Radiance);
            if (cos == 0.3 || cos == -0.95) run_all_lobes(c, direction(cos, 4), TransportMode::Importance);
        }
    }
    EXPECT_LE(tests_run, kTestsAtMost);
}

/// Directions that n_s and n_g put on different sides are refused; the density must say so.
TEST(BsdfSampling, DensityIsThatOfTheSamplesUnderATiltedNormal) {
    for (const BsdfCase& c : bsdf_cases()) {
        if (!flat(c.model).connectible() || c.lobe_width < 0.05) continue;
        for (TransportMode mode : kModes) {
            const double cos = mode == TransportMode::Radiance ? 0.4 : -0.5;
            run({c.name + ", tilted", tilted(c.model), direction(cos, 0.2), mode, Side::Both, {}});
        }
    }
    EXPECT_LE(tests_run, kTestsAtMost);
}

}  // namespace
}  // namespace etendue::test
