// The geometry traced for a light is the surface that the light samples, and faces as it emits.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/light/light_cases.h"
#include "math/rng.h"

namespace etendue {
namespace {

constexpr double kFloatTolerance = 1e-6;

LightPoint point_on(const LightDesc& desc, Rng& rng) {
    const Vec2 u_point = rng.next_2d();
    return make_light(desc, test::kBounds)->sample_emission(u_point, rng.next_2d()).y;
}

Vec3 front(const TriangleMesh& mesh, std::size_t triangle) {
    const Vec3 p = mesh.point(triangle, 0);
    return normalize(cross(mesh.point(triangle, 1) - p, mesh.point(triangle, 2) - p)) * mesh.outward;
}

/// Inside the triangle or not, by the signs of its edge functions.
bool holds(const TriangleMesh& mesh, std::size_t triangle, const Vec3& p) {
    const Vec3 n = front(mesh, triangle) * mesh.outward;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 a = mesh.point(triangle, i);
        const Vec3 b = mesh.point(triangle, (i + 1) % 3);
        if (dot(cross(b - a, p - a), n) < -kFloatTolerance) return false;
    }
    return true;
}

TEST(LightShape, RectIsTheSampledParallelogram) {
    for (const Matrix4& m : {Matrix4{}, test::scaling(-2, 1, 1), test::general(), test::general(-1)}) {
        const LightDesc desc = test::light_desc(LightKind::Rect, m);
        const auto shape = make_light_shape(desc);
        ASSERT_TRUE(shape);
        const auto& mesh = std::get<TriangleMesh>(*shape);
        ASSERT_EQ(mesh.triangles.size(), 2u);
        Rng rng(41, 0, 0);
        for (int i = 0; i < 200; ++i) {
            const LightPoint y = point_on(desc, rng);
            int in = 0;
            for (const std::size_t t : {0u, 1u}) {
                EXPECT_LT(length(front(mesh, t) - y.n), kFloatTolerance);
                EXPECT_NEAR(dot(y.p - mesh.point(t, 0), y.n), 0, kFloatTolerance);
                in += holds(mesh, t, y.p) ? 1 : 0;
            }
            EXPECT_GE(in, 1);
        }
    }
}

TEST(LightShape, CurvedLightsAreTheSampledQuadrics) {
    for (const LightKind kind : {LightKind::Disk, LightKind::Sphere, LightKind::Cylinder}) {
        for (const Matrix4& m : {Matrix4{}, test::scaling(-2, 1, 1), test::general(), test::general(-1)}) {
            const LightDesc desc = test::light_desc(kind, m);
            const auto shape = make_light_shape(desc);
            ASSERT_TRUE(shape);
            const auto& quadric = std::get<Quadric>(*shape);
            Rng rng(42, 0, 0);
            for (int i = 0; i < 200; ++i) {
                const LightPoint y = point_on(desc, rng);
                EXPECT_LT(length(quadric.normal(y.p) - y.n), 1e-9);
                const auto t = quadric.intersect(y.p + y.n * 2, -y.n, 0, 3);
                ASSERT_TRUE(t);
                EXPECT_NEAR(*t, 2, 1e-9);
            }
        }
    }
}

TEST(LightShape, NoneForPointsInfiniteAndMeshLights) {
    LightDesc point = test::light_desc(LightKind::Sphere);
    point.treat_as_point = true;
    EXPECT_FALSE(make_light_shape(point));
    point.treat_as_point = false;
    point.radius = 0;
    EXPECT_FALSE(make_light_shape(point));
    LightDesc line = test::light_desc(LightKind::Cylinder);
    line.treat_as_line = true;
    EXPECT_FALSE(make_light_shape(line));
    line.treat_as_line = false;
    line.radius = 0;
    EXPECT_FALSE(make_light_shape(line));
    for (const LightKind kind : {LightKind::Distant, LightKind::Dome, LightKind::Mesh}) {
        EXPECT_FALSE(make_light_shape(test::light_desc(kind)));
    }
}

}  // namespace
}  // namespace etendue
