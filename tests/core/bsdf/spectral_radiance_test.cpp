// Radiance per what? Particles cross into a dispersive dielectric, each with its own index, unscaled (theory.md §5).
// Tallied inside, their radiance is eta^2 times that outside per unit frequency and per unit vacuum wavelength, and
// eta^3 times per unit wavelength in the medium. Dispersion adds to the last what the change of the index with the
// wavelength does to a band's width.

#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "bsdf/fresnel.h"
#include "math/constants.h"
#include "math/sampling.h"
#include "support/bsdf_cases.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

/// Cauchy's index, wavelengths in vacuum and in micrometres.
struct Glass {
    double a;
    double b;

    [[nodiscard]] double eta(double wavelength) const { return a + b / (wavelength * wavelength); }
    /// d ln eta / d ln wavelength.
    [[nodiscard]] double dispersion(double wavelength) const {
        return -2 * b / (wavelength * wavelength) / eta(wavelength);
    }
};

/// Ultraviolet for short: strong dispersion shows.
constexpr double kWavelength = 0.4;
constexpr double kHalfBand = 0.01;     ///< relative half-width of the band that is tallied
constexpr double kHalfSource = 0.025;  ///< of the one that is emitted
constexpr double kSinCone = 0.5;       ///< half-angle of the cone of directions inside
constexpr double kSpeedOfLight = 1;    ///< frequency = this / wavelength

/// A wavelength and the power per area and unit of emitted radiance per vacuum wavelength that a particle brings into
/// the cone, with Fresnel's transmittance divided out.
struct Particle {
    double wavelength;
    double power;
};

Particle send(const Glass& glass, Rng& rng) {
    const double width = 2 * kHalfSource * kWavelength;
    Particle particle{kWavelength + width * (rng.next_1d() - 0.5), 0};
    const double eta = glass.eta(particle.wavelength);
    const Vec3 wo = sample_cosine_hemisphere(rng.next_2d());
    const auto inside = draw(flat(Dielectric(eta, 0)), wo, TransportMode::Importance, rng);
    if (!inside || !inside->transmission || std::hypot(inside->wi.x, inside->wi.y) > kSinCone) return particle;
    particle.power = kPi * width * inside->weight.r / (1 - fresnel_dielectric(wo.z, eta));
    return particle;
}

enum class Axis { VacuumWavelength, MediumWavelength, Frequency };

double coordinate(Axis axis, const Glass& glass, double wavelength) {
    if (axis == Axis::Frequency) return kSpeedOfLight / wavelength;
    return axis == Axis::MediumWavelength ? wavelength / glass.eta(wavelength) : wavelength;
}

/// Radiance inside per unit of `axis`, at kWavelength, where radiance outside is 1 per unit of vacuum wavelength.
Estimate radiance_inside(const Glass& glass, Axis axis) {
    const double centre = coordinate(axis, glass, kWavelength);
    const double projected_solid_angle = kPi * kSinCone * kSinCone;
    Estimate radiance;
    Rng rng(51, static_cast<std::uint64_t>(axis), 0);
    const int n = samples(1000000);
    for (int i = 0; i < n; ++i) {
        const Particle particle = send(glass, rng);
        const double x = coordinate(axis, glass, particle.wavelength) / centre - 1;
        const double density = 1 / (2 * kHalfBand * centre * projected_solid_angle);
        radiance.add(std::abs(x) < kHalfBand ? particle.power * density : 0);
    }
    return radiance;
}

class SpectralRadiance : public testing::TestWithParam<Glass> {
protected:
    double eta_ = GetParam().eta(kWavelength);
};

TEST_P(SpectralRadiance, ScalesBySquaredIndexPerVacuumWavelength) {
    EXPECT_TRUE(agrees(radiance_inside(GetParam(), Axis::VacuumWavelength), eta_ * eta_));
}

TEST_P(SpectralRadiance, ScalesBySquaredIndexPerFrequency) {
    const double outside = kWavelength * kWavelength / kSpeedOfLight;  // |d wavelength / d frequency|
    EXPECT_TRUE(agrees(radiance_inside(GetParam(), Axis::Frequency), eta_ * eta_ * outside));
}

TEST_P(SpectralRadiance, ScalesByCubedIndexPerWavelengthInTheMedium) {
    const double band = 1 / (1 - GetParam().dispersion(kWavelength));
    EXPECT_TRUE(agrees(radiance_inside(GetParam(), Axis::MediumWavelength), std::pow(eta_, 3) * band));
}

/// What the renderer multiplies radiance by, looking out of the glass, is the factor per frequency.
TEST_P(SpectralRadiance, RendererScalesPerFrequency) {
    const auto out = flat(Dielectric(eta_, 0)).sample({0, 0, -1}, 0.999, {}, TransportMode::Radiance, kCorrect);
    ASSERT_TRUE(out && out->transmission);
    EXPECT_NEAR(out->weight.r, eta_ * eta_, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Glasses, SpectralRadiance, testing::Values(Glass{1.5, 0}, Glass{1.333, 0}, Glass{1.45, 0.02}));

}  // namespace
}  // namespace etendue::test
