#include "geometry/triangulate.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/math/random_math.h"

namespace etendue::test {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

Triangles cut(const std::vector<Vec3>& corners) {
    Triangles triangles;
    triangulate_polygon(corners, triangles);
    return triangles;
}

Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) { return cross(b - a, c - a) * 0.5; }

Vec3 polygon_area_vector(const std::vector<Vec3>& corners) {
    Vec3 sum;
    for (std::size_t i = 2; i < corners.size(); ++i) sum += area_vector(corners[0], corners[i - 1], corners[i]);
    return sum;
}

/// n - 2 triangles whose corners are the polygon's, none turned over and none over another: then areas without sign
/// add up to the polygon's.
void expect_exact_cut(const std::vector<Vec3>& corners) {
    const Triangles triangles = cut(corners);
    ASSERT_EQ(triangles.size(), corners.size() - 2);
    const Vec3 whole = polygon_area_vector(corners);
    const double area = length(whole);
    double sum = 0;
    for (const auto& t : triangles) {
        for (int corner : t) {
            ASSERT_GE(corner, 0);
            ASSERT_LT(corner, static_cast<int>(corners.size()));
        }
        const auto at = [&](std::size_t i) { return corners[static_cast<std::size_t>(t[i])]; };
        const Vec3 part = area_vector(at(0), at(1), at(2));
        EXPECT_GE(dot(part, whole), -1e-12 * area * area);
        sum += length(part);
    }
    EXPECT_NEAR(sum, area, 1e-9 * area);
}

/// As drawn, backwards, and started at each corner; tilted and scaled.
void expect_exact_cuts(const std::vector<std::pair<double, double>>& outline) {
    Rng rng(1, 0, 0);
    for (double scale : {1e-6, 1.0, 1e6}) {
        const Frame f = Frame::from_normal(random_direction(rng));
        const Vec3 origin = random_point(rng, 3 * scale);
        std::vector<Vec3> corners;
        for (const auto& [x, y] : outline) corners.push_back(origin + f.to_world(Vec3{x, y, 0} * scale));
        for (std::size_t start = 0; start < corners.size(); ++start) {
            expect_exact_cut(corners);
            expect_exact_cut({corners.rbegin(), corners.rend()});
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        }
    }
}

TEST(Triangulate, LeavesTrianglesAlone) { EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}})); }

TEST(Triangulate, FansOutConvexPolygons) {
    EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    std::vector<std::pair<double, double>> round;
    for (int i = 0; i < 23; ++i) round.emplace_back(std::cos(i * 2 * kPi / 23), std::sin(i * 2 * kPi / 23));
    expect_exact_cuts(round);
}

TEST(Triangulate, CutsConcavePolygons) {
    expect_exact_cuts({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}});                  // L
    expect_exact_cuts({{0, 0}, {2, 1}, {4, 0}, {2, 4}});                                  // dart
    expect_exact_cuts({{0, 0}, {5, 0}, {5, 4}, {3, 4}, {3, 1}, {2, 1}, {2, 4}, {0, 4}});  // U
    expect_exact_cuts({{0, 0}, {6, 0}, {6, 5}, {1, 5}, {1, 2}, {4, 2}, {4, 3}, {2, 3}, {2, 4}, {5, 4}, {5, 1}, {0, 1}});
}

TEST(Triangulate, CutsStars) {
    for (int points : {3, 5, 12}) {
        std::vector<std::pair<double, double>> star;
        for (int i = 0; i < 2 * points; ++i) {
            const double r = i % 2 == 0 ? 1 : 0.2;
            star.emplace_back(r * std::cos(i * kPi / points), r * std::sin(i * kPi / points));
        }
        expect_exact_cuts(star);
    }
}

TEST(Triangulate, CutsRandomSimplePolygons) {
    Rng rng(2, 0, 0);
    for (int k = 0; k < 20; ++k) {
        std::vector<std::pair<double, double>> outline;
        for (int i = 0; i < 15; ++i) {
            const double r = 0.1 + rng.next_1d();
            outline.emplace_back(r * std::cos(i * 2 * kPi / 15), r * std::sin(i * 2 * kPi / 15));
        }
        expect_exact_cuts(outline);
    }
}

TEST(Triangulate, TakesCornersAlongAStraightEdge) {
    expect_exact_cuts({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
    expect_exact_cuts({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}});
}

TEST(Triangulate, TakesRepeatedCorners) { expect_exact_cuts({{0, 0}, {2, 0}, {2, 0}, {2, 2}, {0, 2}}); }

// A hole joined to the outline by a bridge that is walked twice: how modelling programs write faces with holes.
TEST(Triangulate, TakesHolesJoinedByABridge) {
    expect_exact_cuts({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}});
}

// A bent polygon is cut by its mean plane; the cut's area vector is the polygon's whatever the diagonals.
TEST(Triangulate, TakesBentPolygons) {
    Rng rng(3, 0, 0);
    for (int k = 0; k < 50; ++k) {
        std::vector<Vec3> corners;
        for (int i = 0; i < 9; ++i) {
            const double r = 0.5 + rng.next_1d();
            corners.emplace_back(r * std::cos(i * 2 * kPi / 9), r * std::sin(i * 2 * kPi / 9),
                                 0.1 * (rng.next_1d() - 0.5));
        }
        const Vec3 whole = polygon_area_vector(corners);
        Vec3 sum;
        for (const auto& t : cut(corners)) {
            const auto at = [&](std::size_t i) { return corners[static_cast<std::size_t>(t[i])]; };
            const Vec3 part = area_vector(at(0), at(1), at(2));
            EXPECT_GT(dot(part, whole), 0);
            sum += part;
        }
        EXPECT_LE(length(sum - whole), 1e-12);
    }
}

TEST(Triangulate, SurvivesDegeneratePolygons) {
    EXPECT_EQ(cut({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).size(), 2U);             // a point
    EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}).size(), 3U);  // a line
    EXPECT_EQ(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 2U);             // a bow tie
}

}  // namespace
}  // namespace etendue::test
