#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "math/frame.h"
#include "math/rng.h"
#include "math/vec.h"

namespace etendue::test {

/// Pearson's chi-squared test of a sampler against the density it claims. The domain is cut into cells, the density is
/// integrated over each by adaptive quadrature, and the counts must be what multinomial chance makes of that. A sampler
/// may return nothing: that is one more cell, and its share is what the density leaves to 1.

/// Significance per test such that `tests` right samplers together raise a false alarm at `suite_rate` (Sidak).
[[nodiscard]] double sidak(double suite_rate, int tests);

struct Chi2Settings {
    int samples = 200000;  ///< at full effort (estimate.h)
    double significance = 1e-6;
    std::uint64_t seed = 1;
};

struct Chi2Result {
    bool passed = false;
    double p_value = 0;
    double statistic = 0;
    int degrees_of_freedom = 0;
    double integral = 0;  ///< of the density over the domain
    const char* reason = "";
};

/// EXPECT_TRUE(passes(chi2_...)) shows what went wrong.
[[nodiscard]] testing::AssertionResult passes(const Chi2Result& result);

/// A rectangle of the plane, cut along both axes.
struct Grid {
    std::vector<double> x_edges;
    std::vector<double> y_edges;
};
[[nodiscard]] std::vector<double> even_edges(double low, double high, int cells);

using PlaneSampler = std::function<std::optional<Vec2>(Rng&)>;
using PlaneDensity = std::function<double(const Vec2&)>;
[[nodiscard]] Chi2Result chi2_plane(const PlaneSampler& sampler, const PlaneDensity& density, const Grid& grid,
                                    const Chi2Settings& settings);

/// The unit square.
[[nodiscard]] Chi2Result chi2_square(const PlaneSampler& sampler, const PlaneDensity& density,
                                     const Chi2Settings& settings, int cells = 16);

using DirectionSampler = std::function<std::optional<Vec3>(Rng&)>;
using DirectionDensity = std::function<double(const Vec3&)>;  ///< per solid angle

/// Cells on the sphere, in 1 - cos(theta) and phi about frame.n; put frame.n where the density has its peak.
struct SphereGrid {
    Frame frame = Frame::from_normal({0, 0, 1});
    int azimuths = 16;
    std::vector<double> one_minus_cos_edges = even_edges(0, 2, 20);
};
/// For a lobe of about `half_angle` radians round `axis`: rings that widen from a quarter of it to the whole sphere.
[[nodiscard]] SphereGrid narrow_grid(const Vec3& axis, double half_angle);

[[nodiscard]] Chi2Result chi2_sphere(const DirectionSampler& sampler, const DirectionDensity& density,
                                     const SphereGrid& grid, const Chi2Settings& settings);

}  // namespace etendue::test
