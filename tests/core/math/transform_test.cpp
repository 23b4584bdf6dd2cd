#include "math/transform.h"

#include <limits>

#include <gtest/gtest.h>

#include <etendue/error.h>

#include "core/math/random_math.h"
#include "math/frame.h"

namespace etendue::test {
namespace {

// A few dozen double operations on numbers of the sizes at hand.
constexpr double kTolerance = 1e-13;

void expect_near(const Vec3& a, const Vec3& b, double tolerance) { EXPECT_LE(length(a - b), tolerance); }

TEST(Transform, InverseUndoesIt) {
    Rng rng(1, 0, 0);
    for (int i = 0; i < 100; ++i) {
        const Transform m(random_affine(rng, 1, random_point(rng, 5), i % 2 == 1));
        const Vec3 p = random_point(rng, 3);
        expect_near(m.inverse_point(m.point(p)), p, 100 * kTolerance);
        expect_near(m.inverse().point(m.point(p)), p, 100 * kTolerance);
        expect_near(m.inverse_vector(m.vector(p)), p, 100 * kTolerance);
        expect_near(m.inverse_normal(m.normal(p)), p, 100 * kTolerance);
        expect_near((m.inverse() * m).point(p), p, 100 * kTolerance);
        EXPECT_NEAR(m.determinant() * m.inverse().determinant(), 1, kTolerance);
        EXPECT_EQ(m.flips_handedness(), i % 2 == 1);
    }
}

TEST(Transform, ProductAppliesTheRightOneFirst) {
    Rng rng(2, 0, 0);
    for (int i = 0; i < 20; ++i) {
        const Transform a(random_affine(rng, 2, random_point(rng, 5), i % 2 == 1));
        const Transform b(random_affine(rng, 0.5, random_point(rng, 5), i % 3 == 1));
        const Vec3 p = random_point(rng, 3);
        const Transform ab = a * b;
        expect_near(ab.point(p), a.point(b.point(p)), 100 * kTolerance);
        expect_near(ab.vector(p), a.vector(b.vector(p)), 100 * kTolerance);
        expect_near(ab.normal(p), a.normal(b.normal(p)), 1000 * kTolerance);
        EXPECT_EQ(ab.flips_handedness(), a.flips_handedness() != b.flips_handedness());
    }
}

TEST(Transform, NormalsStayPerpendicularAndOutward) {
    Rng rng(3, 0, 0);
    for (int i = 0; i < 100; ++i) {
        const Transform m(random_affine(rng, 1, random_point(rng, 5), i % 2 == 1));
        const Frame f = Frame::from_normal(random_direction(rng));
        const Vec3 n = normalize(m.normal(f.n));
        EXPECT_NEAR(dot(n, m.vector(f.s)), 0, kTolerance);
        EXPECT_NEAR(dot(n, m.vector(f.t)), 0, kTolerance);
        // What lies in front of a surface stays in front of it, mirrored or not.
        EXPECT_GT(dot(n, m.vector(f.n)), 0);
    }
}

TEST(Transform, HoldsAtAllScales) {
    for (double scale : {1e-30, 1e-6, 1.0, 1e6, 1e30}) {
        const Transform m(scaling(scale, scale, scale, {scale, 0, 0}));
        expect_near(m.inverse_point(m.point({1, 2, 3})), {1, 2, 3}, kTolerance);
    }
}

TEST(Transform, DividesByTheLastElement) {
    Matrix4 doubled = scaling(2, 2, 2, {4, 6, 8});
    doubled.m[15] = 2;
    const Transform m(doubled);
    EXPECT_EQ(m.point({1, 1, 1}), (Vec3{3, 4, 5}));
    EXPECT_EQ(m.determinant(), 1);
}

TEST(Transform, MagnitudeBoundsEveryOrderOfSummation) {
    Rng rng(4, 0, 0);
    for (int i = 0; i < 100; ++i) {
        const Transform m(random_affine(rng, 1, random_point(rng, 5), false));
        const Vec3 p = random_point(rng, 3);
        const Vec3 bound = m.magnitude(p);
        const Vec3 q = m.point(p);
        for (int axis = 0; axis < 3; ++axis) EXPECT_GE(bound[axis], std::abs(q[axis]));
    }
}

TEST(Transform, GivesEmbreeItsColumns) {
    const Transform m(Matrix4{{1, 2, 3, 4, 0, 5, 6, 7, 0, 0, 8, 9, 0, 0, 0, 1}});
    EXPECT_EQ(m.to_float3x4(), (std::array<float, 12>{1, 0, 0, 2, 5, 0, 3, 6, 8, 4, 7, 9}));
}

TEST(Transform, RefusesWhatCannotBeInverted) {
    EXPECT_THROW(Transform(scaling(1, 0, 1)), SceneError);
    EXPECT_THROW(Transform(scaling(1, 1e-200, 1)), SceneError);  // normals would have no length
    // Flattened along a direction that is no axis: rounding leaves a determinant of 1e-17, not 0.
    const Frame f = Frame::from_normal(normalize(Vec3{1, 2, 3}));
    const auto flatten = [&](const Vec3& axis) {
        const Vec3 l = f.to_local(axis);
        return f.to_world({l.x, l.y, 0});
    };
    EXPECT_THROW(Transform(from_columns(flatten({1, 0, 0}), flatten({0, 1, 0}), flatten({0, 0, 1}), {})), SceneError);
    // Very flat is not singular.
    EXPECT_NO_THROW(Transform(scaling(1, 1e-9, 1)));
    EXPECT_THROW(Transform(scaling(1e-120, 1e-120, 1e-120)), SceneError);
    EXPECT_THROW(Transform(scaling(1e120, 1e120, 1e120)), SceneError);
}

TEST(Transform, RefusesWhatIsNotFiniteOrNotAffine) {
    for (std::size_t i = 0; i < 16; ++i) {
        for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            Matrix4 m;
            m.m[i] = bad;
            EXPECT_THROW(Transform{m}, SceneError);
        }
    }
    for (std::size_t i : {12U, 13U, 14U}) {
        Matrix4 m;
        m.m[i] = 0.1;
        EXPECT_THROW(Transform{m}, SceneError);
    }
    Matrix4 m;
    m.m[15] = 0;
    EXPECT_THROW(Transform{m}, SceneError);
    m.m[15] = 1e-310;  // finite, its reciprocal is not
    EXPECT_THROW(Transform{m}, SceneError);
}

TEST(Frame, IsRightHandedAndOrthonormal) {
    Rng rng(5, 0, 0);
    std::vector<Vec3> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {1, 0, -0.0}};
    for (int i = 0; i < 1000; ++i) normals.push_back(random_direction(rng));
    for (double tilt : {1e-4, 1e-8, 1e-12}) normals.push_back(normalize(Vec3{tilt, -tilt, -1}));
    for (const Vec3& n : normals) {
        const Frame f = Frame::from_normal(n);
        EXPECT_EQ(f.n, n);
        expect_near(cross(f.s, f.t), f.n, kTolerance);
        EXPECT_NEAR(length(f.s), 1, kTolerance);
        EXPECT_NEAR(length(f.t), 1, kTolerance);
        EXPECT_NEAR(dot(f.s, f.t), 0, kTolerance);
        const Vec3 v = random_direction(rng);
        expect_near(f.to_world(f.to_local(v)), v, 10 * kTolerance);
    }
}

}  // namespace
}  // namespace etendue::test
