#include "geometry/quadric.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/math/random_math.h"

namespace etendue::test {
namespace {

Quadric sphere(double radius, const Matrix4& placement = {}) {
    return {QuadricKind::Sphere, radius, false, Transform(placement)};
}

TEST(Quadric, SphereHitsOnItsSurface) {
    Rng rng(1, 0, 0);
    for (int i = 0; i < 1000; ++i) {
        const double radius = 0.5 + rng.next_1d();
        const Quadric q = sphere(radius, random_affine(rng, 1, random_point(rng, 3), i % 2 == 1));
        // Aimed from outside at a point inside: must hit, and from there inwards must hit again.
        const Vec3 target = q.parent_from_object.point(random_direction(rng) * (radius * 0.99 * rng.next_1d()));
        const Vec3 origin = q.parent_from_object.translation() + random_direction(rng) * 20;
        const Vec3 d = normalize(target - origin);
        const auto t = q.intersect(origin, d, 0, kInfinity);
        ASSERT_TRUE(t);
        const Vec3 p = origin + d * *t;
        EXPECT_NEAR(length(q.parent_from_object.inverse_point(p)), radius, 1e-12);
        EXPECT_LT(dot(q.normal(p), d), 0);
        EXPECT_NEAR(length(q.normal(p)), 1, 1e-12);
        const auto far = q.intersect(origin, d, *t + 1e-9, kInfinity);
        ASSERT_TRUE(far);
        EXPECT_GT(dot(q.normal(origin + d * *far), d), 0);
        EXPECT_GT(*far, length(target - origin));
        EXPECT_FALSE(q.intersect(origin, d, *far + 1e-9, kInfinity));
        EXPECT_FALSE(q.intersect(origin, d, 0, *t));
        EXPECT_FALSE(q.intersect(origin, -d, 0, kInfinity));
        // From inside only the far root lies ahead.
        EXPECT_NEAR(*q.intersect(target, d, 0, kInfinity), *far - length(target - origin), 1e-10);
    }
}

TEST(Quadric, TubeIsOpenAtItsEnds) {
    const Quadric tube{QuadricKind::Tube, 0.5, false, {}, 2};
    EXPECT_FALSE(tube.intersect({-9, 0.1, 0.2}, {1, 0, 0}, 0, kInfinity));  // right through
    EXPECT_NEAR(*tube.intersect({0, 3, 0}, {0, -1, 0}, 0, kInfinity), 2.5, 1e-14);
    EXPECT_NEAR(*tube.intersect({0, 0, 0}, {0, -1, 0}, 0, kInfinity), 0.5, 1e-14);  // from within
    EXPECT_FALSE(tube.intersect({2.01, 3, 0}, {0, -1, 0}, 0, kInfinity));
    // In by an end, out through the wall: the first root lies beyond the end.
    const Vec3 d = normalize(Vec3{1, 0.25, 0});
    const auto t = tube.intersect({-3, -0.4, 0}, d, 0, kInfinity);
    ASSERT_TRUE(t);
    EXPECT_NEAR((Vec3{-3, -0.4, 0} + d * *t).y, 0.5, 1e-14);
}

TEST(Quadric, TubeHitsOnItsSurface) {
    Rng rng(8, 0, 0);
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        const Quadric q{QuadricKind::Tube, 0.5 + rng.next_1d(), false,
                        Transform(random_affine(rng, 1, random_point(rng, 3), i % 2 == 1)), 0.3 + rng.next_1d()};
        const Vec3 target = q.parent_from_object.point({(2 * rng.next_1d() - 1) * q.half_length, 0, 0});
        const Vec3 origin = q.parent_from_object.translation() + random_direction(rng) * 20;
        const Vec3 d = normalize(target - origin);
        const auto t = q.intersect(origin, d, 0, kInfinity);
        if (!t) continue;  // through an end and out by the other
        ++hits;
        const Vec3 p = origin + d * *t;
        const Vec3 o = q.parent_from_object.inverse_point(p);
        EXPECT_NEAR(std::hypot(o.y, o.z), q.radius, 1e-11);
        EXPECT_LE(std::abs(o.x), q.half_length);
        EXPECT_LT(length(q.project(p) - p), 1e-10);
        EXPECT_NEAR(length(q.normal(p)), 1, 1e-12);
        const Vec3 along = q.parent_from_object.vector({1, 0, 0});
        const Vec3 around = q.parent_from_object.vector({0, -o.z, o.y});
        EXPECT_NEAR(dot(q.normal(p), along), 0, 1e-12);
        EXPECT_NEAR(dot(q.normal(p), around), 0, 1e-11);
        const Quadric::Bounds b = q.bounds();
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(p[axis], b.lower[axis] - 1e-10);
            EXPECT_LE(p[axis], b.upper[axis] + 1e-10);
        }
        const Vec2 st = q.st(p);
        EXPECT_NEAR(st.y, o.x / (2 * q.half_length) + 0.5, 1e-10);
    }
    EXPECT_GT(hits, 500);
}

TEST(Quadric, SphereKeepsItsDigitsFarAwayAndTiny) {
    for (double distance : {1e3, 1e6, 1e9}) {
        // In double the distance of a chord to the centre is known to distance * 2^-53 or so.
        const Quadric q = sphere(1);
        const auto t = q.intersect({0.6, 0, distance}, {0, 0, -1}, 0, kInfinity);
        ASSERT_TRUE(t);
        EXPECT_NEAR(*t, distance - 0.8, 4e-16 * distance);
    }
    const Quadric tiny = sphere(1e-6);
    EXPECT_NEAR(*tiny.intersect({6e-7, 0, 1}, {0, 0, -1}, 0, kInfinity), 1 - 8e-7, 4e-16);
    EXPECT_FALSE(tiny.intersect({1.01e-6, 0, 1}, {0, 0, -1}, 0, kInfinity));
    const Quadric planet = sphere(6e6, scaling(1, 1, 1, {0, 0, -6e6}));
    EXPECT_NEAR(*planet.intersect({0, 0, 2}, {0, 0, -1}, 0, kInfinity), 2, 1e-8);
}

TEST(Quadric, TangentsDecideByAHair) {
    const Quadric q = sphere(1);
    EXPECT_TRUE(q.intersect({1 - 1e-12, 0, 5}, {0, 0, -1}, 0, kInfinity));
    EXPECT_FALSE(q.intersect({1 + 1e-12, 0, 5}, {0, 0, -1}, 0, kInfinity));
    // Exactly tangent: whichever, but a finite answer.
    const auto t = q.intersect({1, 0, 5}, {0, 0, -1}, 0, kInfinity);
    EXPECT_TRUE(!t || std::abs(*t - 5) < 1e-6);
    EXPECT_TRUE(q.intersect({0, 0, 0}, {0, 0, 1}, 0, kInfinity));
}

TEST(Quadric, DirectionsNeedNotBeUnit) {
    const Quadric q = sphere(1);
    EXPECT_NEAR(*q.intersect({0, 0, 5}, {0, 0, -8}, 0, kInfinity), 0.5, 1e-15);
    EXPECT_NEAR(*q.intersect({0, 0, 5}, {0, 0, -1e-9}, 0, kInfinity), 4e9, 1e-5);
}

TEST(Quadric, DiskIsHitWithinItsRim) {
    Rng rng(2, 0, 0);
    for (int i = 0; i < 1000; ++i) {
        const Quadric q{QuadricKind::Disk, 0.7, i % 3 == 0,
                        Transform(random_affine(rng, 1, random_point(rng, 3), i % 2 == 1))};
        const double r = rng.next_1d();
        const double phi = 2 * kPi * rng.next_1d();
        const Vec3 target = q.parent_from_object.point({r * std::cos(phi), r * std::sin(phi), 0});
        const Vec3 origin = target + random_direction(rng) * 3;
        const auto t = q.intersect(origin, normalize(target - origin), 0, kInfinity);
        EXPECT_EQ(t.has_value(), r < 0.7);
        if (t) EXPECT_NEAR(*t, 3, 1e-9);
        const Vec3 up = q.parent_from_object.normal({0, 0, q.flipped ? -1.0 : 1.0});
        EXPECT_GT(dot(q.normal(target), up), 0);
    }
    const Quadric disk{QuadricKind::Disk, 1, false, {}};
    EXPECT_FALSE(disk.intersect({0, 0, 0}, {1, 0, 0}, 0, kInfinity));  // edge on
    EXPECT_FALSE(disk.intersect({0, 0, 1}, {1, 0, 0}, 0, kInfinity));
}

TEST(Quadric, ProjectPutsPointsBackOnTheSurface) {
    Rng rng(3, 0, 0);
    for (int i = 0; i < 200; ++i) {
        const Quadric q = sphere(2, random_affine(rng, 1, random_point(rng, 3), false));
        const Vec3 on = q.parent_from_object.point(random_direction(rng) * 2);
        const Vec3 near = on + random_direction(rng) * 1e-6;
        const Vec3 back = q.project(near);
        EXPECT_NEAR(length(q.parent_from_object.inverse_point(back)), 2, 1e-12);
        EXPECT_LT(length(back - near), 1e-5);
    }
}

TEST(Quadric, BoundsAreTightAndHoldEverything) {
    Rng rng(4, 0, 0);
    for (int i = 0; i < 50; ++i) {
        const QuadricKind kind = i % 2 == 0 ? QuadricKind::Sphere : QuadricKind::Disk;
        const Quadric q{kind, 1.3, false, Transform(random_affine(rng, 1, random_point(rng, 3), false))};
        const Quadric::Bounds b = q.bounds();
        Vec3 lower{kInfinity, kInfinity, kInfinity};
        Vec3 upper = -lower;
        for (int k = 0; k < 20000; ++k) {
            Vec3 o = random_direction(rng);
            if (kind == QuadricKind::Disk) o = {std::cos(k * 1e-3), std::sin(k * 1e-3), 0};
            const Vec3 p = q.parent_from_object.point(o * 1.3);
            lower = min(lower, p);
            upper = max(upper, p);
        }
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LE(b.lower[axis], lower[axis] + 1e-12);
            EXPECT_GE(b.upper[axis], upper[axis] - 1e-12);
            // The nearest of 20000 points is within a few 1e-4 of the extreme.
            EXPECT_NEAR(b.lower[axis], lower[axis], 4e-3);
            EXPECT_NEAR(b.upper[axis], upper[axis], 4e-3);
        }
    }
}

TEST(Quadric, TextureCoordinatesAreLongitudeAndLatitude) {
    const Quadric q = sphere(2);
    EXPECT_NEAR(q.st({2, 0, 0}).x, 0, 1e-15);
    EXPECT_NEAR(q.st({0, 2, 0}).x, 0.25, 1e-15);
    EXPECT_NEAR(q.st({0, -2, 0}).x, 0.75, 1e-15);
    EXPECT_NEAR(q.st({2, 0, 0}).y, 0.5, 1e-15);
    EXPECT_NEAR(q.st({0, 0, 2}).y, 1, 1e-15);
    EXPECT_NEAR(q.st({0, 0, -2}).y, 0, 1e-15);
}

}  // namespace
}  // namespace etendue::test
