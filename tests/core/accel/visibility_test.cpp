// Points that see each other must not be told otherwise by rounding, and what stands between must be noticed, at any
// scale.

#include <gtest/gtest.h>

#include "core/accel/convex_bodies.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

std::optional<SurfaceInteraction> wall_point(const Scene& scene, const PlacedBody& room, Rng& rng) {
    const Vec3 o = room.inside(rng);
    const Vec3 w = random_direction(rng);
    return scene.intersect({offset_origin(o, {}, {}, w), w});
}

/// Whether the segment meets both walls at more than a grazing angle; two points of one face do not.
bool faces(const SurfaceInteraction& a, const SurfaceInteraction& b) {
    const Vec3 d = normalize(b.p - a.p);
    return dot(a.n_g, d) < -1e-3 && dot(b.n_g, d) > 1e-3;
}

TEST(Visibility, WallsOfAConvexRoomSeeEachOther) {
    const int pairs = samples(1000);
    for (const Body& body : convex_bodies()) {
        for (const Placement& placement : placements(body)) {
            const PlacedBody room(body, placement, 1);
            const Scene scene(room.description, {});
            Rng rng(2, 0, 0);
            int blocked = 0;
            int seen = 0;
            for (int i = 0; i < pairs; ++i) {
                const auto a = wall_point(scene, room, rng);
                const auto b = wall_point(scene, room, rng);
                ASSERT_TRUE(a && b) << describe(body, placement);
                if (!faces(*a, *b) || !room.clear_of_edges(*a) || !room.clear_of_edges(*b)) continue;
                ++seen;
                if (!scene.visible(RayEnd::on(*a), RayEnd::on(*b))) ++blocked;
                // A point in the middle of the room: a pinhole, a point light.
                const Vec3 middle = room.inside(rng);
                if (!scene.visible(RayEnd::on(*a), RayEnd::free(middle))) ++blocked;
                if (!scene.visible(RayEnd::free(middle), RayEnd::on(*a))) ++blocked;
            }
            EXPECT_GT(seen, pairs / 10) << describe(body, placement);
            EXPECT_EQ(blocked, 0) << describe(body, placement);
        }
    }
}

// From outside a body its near side is seen and its far side is not; what looks along the wall sees nothing through it.
TEST(Visibility, BodiesHideTheirFarSide) {
    const int pairs = samples(1000);
    for (const Body& body : convex_bodies()) {
        for (const Placement& placement : placements(body)) {
            const PlacedBody placed(body, placement, 3);
            const Scene scene(placed.description, {});
            Rng rng(4, 0, 0);
            int wrong = 0;
            for (int i = 0; i < pairs; ++i) {
                const auto a = wall_point(scene, placed, rng);
                ASSERT_TRUE(a) << describe(body, placement);
                const Vec3 eye = placed.inside(rng) + random_direction(rng) * (20 * placement.scale);
                const double cosine = dot(normalize(eye - a->p), a->n_g);
                if (std::abs(cosine) < 1e-3 || !placed.clear_of_edges(*a)) continue;
                const RayEnd end{eye, {}, {}};
                if (scene.visible(end, RayEnd::on(*a)) != (cosine > 0)) ++wrong;
                if (scene.visible(RayEnd::on(*a), end) != (cosine > 0)) ++wrong;
                if (scene.visible(end, RayEnd::free(placed.inside(rng)))) ++wrong;
            }
            EXPECT_EQ(wrong, 0) << describe(body, placement);
        }
    }
}

/// The largest relative distance of the segment from the middle, in units of the pillar's radius.
double passes_at(const Vec3& a, const Vec3& b, const Vec3& center, double radius) {
    const Vec3 d = b - a;
    const double t = std::clamp(dot(center - a, d) / length_squared(d), 0.0, 1.0);
    return length(a + d * t - center) / radius;
}

TEST(Visibility, WhatStandsBetweenIsNoticed) {
    for (double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
        for (double offset : {0.0, 100.0}) {
            for (double size : {0.4, 0.01}) {
                SceneBuilder b;
                const int grey = b.diffuse(0.5);
                const Vec3 center{offset * scale, -offset * scale, 0};
                b.shape(CubeDesc{2 * scale}, grey, scaling(1, 1, 1, center));
                b.sphere(center, size * scale, grey);
                const Scene scene(b.scene(), {});
                const double radius = static_cast<float>(size * scale);
                Rng rng(5, 0, 0);
                int wrong = 0;
                int blocked = 0;
                const auto wall = [&] {
                    // A ray from the pillar outwards meets only the wall.
                    const Vec3 w = random_direction(rng);
                    return scene.intersect({offset_origin(center + w * (1.01 * radius), {}, {}, w), w});
                };
                for (int i = 0; i < samples(2000); ++i) {
                    const auto p = wall();
                    const auto q = wall();
                    ASSERT_TRUE(p && q);
                    if (!faces(*p, *q)) continue;
                    // Half of the pairs are aimed at the pillar.
                    Vec3 aim = q->p;
                    RayEnd end = RayEnd::on(*q);
                    if (i % 2 == 0) {
                        aim = center * 2 - p->p + random_direction(rng) * (1.5 * radius);
                        end = RayEnd::free(center + (aim - center) * 0.9);
                        aim = end.p;
                    }
                    const double at = passes_at(p->p, aim, center, radius);
                    // Float positions are good to offset * 2^-23 or so.
                    if (std::abs(at - 1) < 0.01) continue;
                    blocked += at < 1 ? 1 : 0;
                    if (scene.visible(RayEnd::on(*p), end) != (at > 1)) ++wrong;
                }
                EXPECT_EQ(wrong, 0) << scale << " " << offset << " " << size;
                EXPECT_GT(blocked, samples(2000) / 20);
            }
        }
    }
}

TEST(Visibility, InfinityIsSeenOutwardsOnly) {
    const int rays = samples(1000);
    for (const Body& body : convex_bodies()) {
        for (const Placement& placement : placements(body)) {
            const PlacedBody placed(body, placement, 6);
            const Scene scene(placed.description, {});
            Rng rng(7, 0, 0);
            int wrong = 0;
            for (int i = 0; i < rays; ++i) {
                const auto a = wall_point(scene, placed, rng);
                ASSERT_TRUE(a);
                if (!placed.clear_of_edges(*a)) continue;
                if (!scene.sees_infinity(RayEnd::on(*a), leaving_direction(rng, a->n_g, 1))) ++wrong;
                if (scene.sees_infinity(RayEnd::on(*a), leaving_direction(rng, a->n_g, -1))) ++wrong;
            }
            EXPECT_EQ(wrong, 0) << describe(body, placement);
        }
    }
}

}  // namespace
}  // namespace etendue::test
