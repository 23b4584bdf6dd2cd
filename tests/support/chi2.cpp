#include "support/chi2.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>

#include "math/constants.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

/// Cells expecting fewer samples are pooled: the statistic is chi-squared only for well-filled cells.
constexpr double kMinExpected = 10;
/// The density may integrate to this much more than 1; the quadrature does better.
constexpr double kIntegralSlack = 1e-3;

struct Rectangle {
    Vec2 low;
    Vec2 high;
};

/// Gauss-Legendre, 4 x 4 points.
double gauss(const PlaneDensity& f, const Rectangle& r) {
    constexpr std::array<double, 4> kNodes{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                           0.8611363115940526};
    constexpr std::array<double, 4> kWeights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                             0.3478548451374538};
    const Vec2 half{(r.high.x - r.low.x) / 2, (r.high.y - r.low.y) / 2};
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            const Vec2 p{r.low.x + half.x * (1 + kNodes[i]), r.low.y + half.y * (1 + kNodes[j])};
            sum += kWeights[i] * kWeights[j] * f(p);
        }
    }
    return sum * half.x * half.y;
}

/// Not halves: a jump that lies symmetrically between the points of the whole and of its parts would go unseen.
std::array<Rectangle, 4> parts_of(const Rectangle& r) {
    constexpr double kCut = 0.437;
    const Vec2 mid{r.low.x + kCut * (r.high.x - r.low.x), r.low.y + kCut * (r.high.y - r.low.y)};
    return {
        {{r.low, mid}, {{mid.x, r.low.y}, {r.high.x, mid.y}}, {{r.low.x, mid.y}, {mid.x, r.high.y}}, {mid, r.high}}};
}

/// Halving the tolerance, not quartering it, suits jumps along a curve: each level doubles the cells that have one.
double refine(const PlaneDensity& f, const Rectangle& r, double coarse, double tolerance, int depth) {
    constexpr int kForcedDepth = 2;  // lest a peak fall between the first points
    constexpr int kMaxDepth = 12;
    const std::array<Rectangle, 4> parts = parts_of(r);
    std::array<double, 4> values{};
    double fine = 0;
    for (std::size_t i = 0; i < 4; ++i) fine += values[i] = gauss(f, parts[i]);
    if (depth >= kMaxDepth || (depth >= kForcedDepth && std::abs(fine - coarse) <= tolerance)) return fine;
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += refine(f, parts[i], values[i], tolerance / 2, depth + 1);
    return sum;
}

/// To a small part of the count's own noise.
double cell_probability(const PlaneDensity& density, const Rectangle& cell, int samples) {
    const double coarse = gauss(density, cell);
    const double n = samples;
    const double tolerance = 0.02 * std::sqrt(std::max(coarse, 1 / n) / n);
    return refine(density, cell, coarse, tolerance, 0);
}

struct Cell {
    double expected = 0;
    double observed = 0;
};

std::optional<std::size_t> find_interval(const std::vector<double>& edges, double x) {
    if (!(x >= edges.front() && x <= edges.back())) return std::nullopt;
    const auto above = std::upper_bound(edges.begin(), edges.end() - 1, x);
    return static_cast<std::size_t>(above - edges.begin()) - 1;
}

/// Merges the emptiest cells until each expects kMinExpected.
std::vector<Cell> pool(std::vector<Cell> cells) {
    std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.expected > b.expected; });
    while (cells.size() > 1 && cells.back().expected < kMinExpected) {
        const Cell last = cells.back();
        cells.pop_back();
        cells.back().expected += last.expected;
        cells.back().observed += last.observed;
    }
    return cells;
}

Chi2Result failed(Chi2Result result, const char* reason) {
    result.reason = reason;
    return result;
}

Chi2Result judge(const std::vector<Cell>& all, Chi2Result result, double significance) {
    for (const Cell& cell : all) {
        if (cell.expected < 1e-3 && cell.observed > 5) {
            return failed(result, "samples where the density is zero");
        }
    }
    const std::vector<Cell> cells = pool(all);
    for (const Cell& cell : cells) {
        const double off = cell.observed - cell.expected;
        result.statistic += off * off / cell.expected;
    }
    result.degrees_of_freedom = static_cast<int>(cells.size()) - 1;
    if (result.degrees_of_freedom < 1 && !full_effort()) {  // too few samples for a verdict, as was asked for
        result.passed = true;
        return result;
    }
    if (result.degrees_of_freedom < 1) return failed(result, "too few cells hold samples");
    const boost::math::chi_squared distribution(result.degrees_of_freedom);
    result.p_value = boost::math::cdf(boost::math::complement(distribution, result.statistic));
    result.passed = result.p_value >= significance;
    if (!result.passed) result.reason = "the counts are not what the density says";
    return result;
}

}  // namespace

double sidak(double suite_rate, int tests) { return -std::expm1(std::log1p(-suite_rate) / tests); }

testing::AssertionResult passes(const Chi2Result& result) {
    auto assertion = result.passed ? testing::AssertionSuccess() : testing::AssertionFailure();
    return assertion << result.reason << " (p = " << result.p_value << ", chi2 = " << result.statistic << ", "
                     << result.degrees_of_freedom << " degrees of freedom, density integrates to " << result.integral
                     << ")";
}

std::vector<double> even_edges(double low, double high, int cells) {
    std::vector<double> edges;
    for (int i = 0; i <= cells; ++i) edges.push_back(low + (high - low) * i / cells);
    return edges;
}

Chi2Result chi2_plane(const PlaneSampler& sampler, const PlaneDensity& density, const Grid& grid,
                      const Chi2Settings& settings) {
    const int count = samples(settings.samples);
    const std::size_t columns = grid.x_edges.size() - 1;
    const std::size_t rows = grid.y_edges.size() - 1;
    std::vector<Cell> cells(columns * rows + 1);
    Cell& none = cells.back();

    Chi2Result result;
    for (std::size_t y = 0; y < rows; ++y) {
        for (std::size_t x = 0; x < columns; ++x) {
            const Rectangle cell{{grid.x_edges[x], grid.y_edges[y]}, {grid.x_edges[x + 1], grid.y_edges[y + 1]}};
            const double probability = cell_probability(density, cell, count);
            if (!(probability >= 0)) return failed(result, "the density is negative or not a number");
            cells[y * columns + x].expected = probability * count;
            result.integral += probability;
        }
    }
    none.expected = std::max(0.0, 1 - result.integral) * count;

    Rng rng(settings.seed, 0, 0);
    for (int i = 0; i < count; ++i) {
        const std::optional<Vec2> p = sampler(rng);
        if (!p) {
            none.observed += 1;
            continue;
        }
        const std::optional<std::size_t> x = find_interval(grid.x_edges, p->x);
        const std::optional<std::size_t> y = find_interval(grid.y_edges, p->y);
        if (!x || !y) return failed(result, "a sample lies outside the domain or is not a number");
        cells[*y * columns + *x].observed += 1;
    }
    if (result.integral > 1 + kIntegralSlack) return failed(result, "the density integrates to more than 1");
    // What the quadrature leaves to 1 is no share of anything.
    if (none.expected < kIntegralSlack * count && none.observed == 0) none.expected = 0;
    return judge(cells, result, settings.significance);
}

Chi2Result chi2_square(const PlaneSampler& sampler, const PlaneDensity& density, const Chi2Settings& settings,
                       int cells) {
    const std::vector<double> edges = even_edges(0, 1, cells);
    return chi2_plane(sampler, density, {edges, edges}, settings);
}

SphereGrid narrow_grid(const Vec3& axis, double half_angle) {
    SphereGrid grid;
    grid.frame = Frame::from_normal(axis);
    grid.azimuths = 12;
    grid.one_minus_cos_edges = {0};
    // 1 - cos(a) is about a^2 / 2; neighbouring rings differ by 1.4 in angle.
    double edge = half_angle * half_angle / 32;
    while (edge < 1.4) {
        grid.one_minus_cos_edges.push_back(edge);
        edge *= 2;
    }
    grid.one_minus_cos_edges.push_back(2);
    return grid;
}

Chi2Result chi2_sphere(const DirectionSampler& sampler, const DirectionDensity& density, const SphereGrid& grid,
                       const Chi2Settings& settings) {
    const auto to_plane = [&](Rng& rng) -> std::optional<Vec2> {
        const std::optional<Vec3> w = sampler(rng);
        if (!w) return std::nullopt;
        const Vec3 local = grid.frame.to_local(*w);
        const double sin2 = local.x * local.x + local.y * local.y;
        const double below = local.z > 0 ? sin2 / (1 + local.z) : 1 - local.z;  // 1 - cos with all its digits
        const double phi = std::atan2(local.y, local.x);
        return Vec2{std::min(below, 2.0), phi < 0 ? phi + 2 * kPi : phi};
    };
    const auto plane_density = [&](const Vec2& p) {
        const double sin = std::sqrt(std::max(0.0, p.x * (2 - p.x)));
        return density(grid.frame.to_world({sin * std::cos(p.y), sin * std::sin(p.y), 1 - p.x}));
    };
    return chi2_plane(to_plane, plane_density, {grid.one_minus_cos_edges, even_edges(0, 2 * kPi, grid.azimuths)},
                      settings);
}

}  // namespace etendue::test
