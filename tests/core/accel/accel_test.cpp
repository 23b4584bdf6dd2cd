// Embree against brute force in double.

#include "accel/embree_accel.h"

#include <gtest/gtest.h>

#include "core/math/random_math.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

TriangleMesh random_soup(Rng& rng, int triangles, double size) {
    MeshDesc desc;
    for (int i = 0; i < triangles; ++i) {
        const Vec3 center = random_point(rng, 1);
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 p = center + random_point(rng, size);
            desc.points.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
            desc.face_vertex_indices.push_back(3 * i + corner);
        }
        desc.face_vertex_counts.push_back(3);
    }
    return make_triangle_mesh(desc, {}, "/soup");
}

/// The nearest hit found by trying everything, and whether it is a matter of rounding.
struct Nearest {
    double t = kInfinity;
    double next = kInfinity;  ///< the nearest behind it
    std::uint32_t instance = kNoInstance;
    std::uint32_t geometry = 0;
    std::uint32_t primitive = 0;
    Vec2 uv;
    bool doubtful = false;  ///< some edge is too near to call
};

constexpr double kEdge = 1e-4;      ///< of a triangle's own size; Embree's float is good to some 1e-6
constexpr double kDistance = 2e-5;  ///< absolute, of scenes a few units wide; Embree's float is good to some 1e-6

class BruteForce {
public:
    explicit BruteForce(const Ray& ray) : ray_(ray) {}

    void visit(const PlacedGeometry& geometry, const Transform& placement, std::uint32_t instance,
               std::uint32_t number) {
        instance_ = instance;
        geometry_ = number;
        if (const auto* quadric = std::get_if<Quadric>(&geometry)) {
            visit(*quadric, placement);
            return;
        }
        const auto& mesh = std::get<TriangleMesh>(geometry);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) visit(mesh, t, placement);
    }
    [[nodiscard]] const Nearest& nearest() const { return nearest_; }

private:
    void visit(const TriangleMesh& mesh, std::size_t triangle, const Transform& placement) {
        const Vec3 p0 = placement.point(mesh.point(triangle, 0));
        const Vec3 e1 = placement.point(mesh.point(triangle, 1)) - p0;
        const Vec3 e2 = placement.point(mesh.point(triangle, 2)) - p0;
        const Vec3 n = cross(e1, e2);
        const double slope = dot(ray_.direction, n);
        const double t = dot(p0 - ray_.origin, n) / slope;
        const Vec3 q = ray_.origin + ray_.direction * t - p0;
        const double u = dot(cross(q, e2), n) / length_squared(n);
        const double v = dot(cross(e1, q), n) / length_squared(n);
        const double inside = std::min({u, v, 1 - u - v});
        const bool edge_on = std::abs(slope) < 1e-3 * length(n);
        if (std::abs(inside) < kEdge || (edge_on && inside > -0.1)) nearest_.doubtful = true;
        if (inside > 0 && t > 0) offer(t, static_cast<std::uint32_t>(triangle), {u, v});
    }
    void visit(const Quadric& quadric, const Transform& placement) {
        const Vec3 o = placement.inverse_point(ray_.origin);
        const Vec3 d = placement.inverse_vector(ray_.direction);
        const auto first = quadric.intersect(o, d, 0, kInfinity);
        if (!first) return;
        if (const auto second = quadric.intersect(o, d, *first * (1 + 1e-12), kInfinity)) {
            if (*second - *first < 1e-3) nearest_.doubtful = true;
            offer(*second, 0, {});
        }
        offer(*first, 0, {});
    }
    void offer(double t, std::uint32_t primitive, const Vec2& uv) {
        if (t >= nearest_.t) {
            nearest_.next = std::min(nearest_.next, t);
            return;
        }
        nearest_.next = nearest_.t;
        nearest_.t = t;
        nearest_.instance = instance_;
        nearest_.geometry = geometry_;
        nearest_.primitive = primitive;
        nearest_.uv = uv;
    }

    Ray ray_;
    std::uint32_t instance_ = kNoInstance;
    std::uint32_t geometry_ = 0;
    Nearest nearest_;
};

Ray random_ray(Rng& rng) {
    const Vec3 from = random_point(rng, 3);
    const Vec3 w = normalize(random_point(rng, 1) - from);
    const auto rounded = [](const Vec3& v) {
        return Vec3{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    };
    return {rounded(from), rounded(w)};
}

void expect_same_hits(const AccelInput& input, int rays, std::uint64_t seed) {
    const EmbreeAccel accel(input);
    Rng rng(seed, 1, 0);
    int decided = 0;
    int hits = 0;
    for (int i = 0; i < rays; ++i) {
        const Ray ray = random_ray(rng);
        BruteForce brute(ray);
        for (std::uint32_t g = 0; g < input.top.size(); ++g) brute.visit(*input.top[g], {}, kNoInstance, g);
        for (std::uint32_t k = 0; k < input.instances.size(); ++k) {
            const auto& group = input.groups[input.instances[k].group];
            for (std::uint32_t g = 0; g < group.size(); ++g) {
                brute.visit(*group[g], input.instances[k].world_from_group, k, g);
            }
        }
        const Nearest& expected = brute.nearest();
        if (expected.doubtful || expected.t < kDistance || expected.next - expected.t < 1e-4) continue;
        ++decided;
        const auto hit = accel.intersect(ray);
        ASSERT_EQ(hit.has_value(), expected.t < kInfinity) << i;
        if (!hit) {
            EXPECT_FALSE(accel.occluded(ray, kInfinity));
            continue;
        }
        ++hits;
        EXPECT_EQ(hit->instance, expected.instance);
        EXPECT_EQ(hit->geometry, expected.geometry);
        EXPECT_EQ(hit->primitive, expected.primitive);
        EXPECT_NEAR(hit->t, expected.t, kDistance);
        EXPECT_NEAR(hit->u, expected.uv.x, kEdge);
        EXPECT_NEAR(hit->v, expected.uv.y, kEdge);
        EXPECT_TRUE(accel.occluded(ray, kInfinity));
        EXPECT_TRUE(accel.occluded(ray, expected.t + kDistance));
        EXPECT_FALSE(accel.occluded(ray, expected.t - kDistance));
    }
    EXPECT_GT(decided, rays / 2);
    EXPECT_GT(hits, rays / 10);
}

TEST(Accel, FindsWhatBruteForceFinds) {
    Rng rng(1, 0, 0);
    const PlacedGeometry few = random_soup(rng, 40, 0.6);
    const PlacedGeometry many = random_soup(rng, 150, 0.2);
    const PlacedGeometry ball = Quadric{QuadricKind::Sphere, 0.3, false, Transform(scaling(1, 2, 0.5, {0.3, 0, 0}))};
    AccelInput input;
    input.top = {&few, &ball, &many};
    expect_same_hits(input, samples(20000), 1);
}

TEST(Accel, FindsWhatBruteForceFindsInInstances) {
    Rng rng(2, 0, 0);
    const PlacedGeometry floor = random_soup(rng, 10, 0.6);
    const PlacedGeometry soup = random_soup(rng, 20, 0.4);
    const PlacedGeometry ball = Quadric{QuadricKind::Sphere, 0.5, false, Transform(scaling(1, 1, 0.5, {0.5, 0, 0}))};
    const PlacedGeometry disk = Quadric{QuadricKind::Disk, 0.4, false, {}};
    AccelInput input;
    input.top = {&floor};
    input.groups = {{&soup, &ball}, {&disk, &soup}};
    for (int i = 0; i < 6; ++i) {
        input.instances.push_back(
            {static_cast<std::size_t>(i % 2), Transform(random_affine(rng, 0.4, random_point(rng, 1), i % 3 == 1))});
    }
    expect_same_hits(input, samples(20000), 2);
}

TEST(Accel, BoundsHoldEverything) {
    Rng rng(3, 0, 0);
    const PlacedGeometry soup = random_soup(rng, 20, 0.4);
    const PlacedGeometry ball = Quadric{QuadricKind::Sphere, 2, false, {}};
    AccelInput input;
    input.top = {&soup, &ball};
    input.groups = {{&ball}};
    input.instances.push_back({0, Transform(scaling(1, 2, 1, {10, 0, 0}))});
    const auto bounds = EmbreeAccel(input).bounds();
    ASSERT_TRUE(bounds);
    EXPECT_NEAR(bounds->lower.x, -2, 1e-5);
    EXPECT_NEAR(bounds->upper.x, 12, 1e-5);
    EXPECT_NEAR(bounds->upper.y, 4, 1e-5);
    EXPECT_LE(bounds->lower.z, -2);
}

TEST(Accel, IsEmptyWithoutGeometry) {
    const EmbreeAccel accel(AccelInput{});
    EXPECT_FALSE(accel.bounds());
    EXPECT_FALSE(accel.intersect({{0, 0, 0}, {0, 0, 1}}));
    EXPECT_FALSE(accel.occluded({{0, 0, 0}, {0, 0, 1}}, kInfinity));
}

}  // namespace
}  // namespace etendue::test
