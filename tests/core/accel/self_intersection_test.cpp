// Rays that leave a surface must not find it again, at any scale: a convex closed body left outwards is never hit
// again, left inwards its far side is.

#include <gtest/gtest.h>

#include "core/accel/convex_bodies.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

struct Tally {
    int rays = 0;
    int hit_again = 0;
    int lost = 0;       ///< found nothing inside a closed body
    int near_side = 0;  ///< found a surface that faces the ray, from inside
};

void leave(const Scene& scene, const PlacedBody& body, const SurfaceInteraction& si, Rng& rng, Tally& tally) {
    if (!body.clear_of_edges(si)) return;
    ++tally.rays;
    const Vec3 out = leaving_direction(rng, si.n_g, 1);
    if (scene.intersect({offset_origin(si.p, si.p_error, si.n_g, out), out})) ++tally.hit_again;
    const Vec3 in = leaving_direction(rng, si.n_g, -1);
    const auto far = scene.intersect({offset_origin(si.p, si.p_error, si.n_g, in), in});
    if (!far) {
        ++tally.lost;
    } else if (!(dot(far->n_g, in) > 0)) {
        ++tally.near_side;
    }
}

Tally leave_body(const Body& body, const Placement& placement, int rays) {
    const PlacedBody placed(body, placement, 1);
    const Scene scene(placed.description, {});
    Rng rng(2, 0, 0);
    Tally tally;
    for (int i = 0; i < rays; ++i) {
        // From inside, and from outside: both sides of the surface are met.
        const Vec3 o = placed.inside(rng);
        const Vec3 w = random_direction(rng);
        auto si = scene.intersect({offset_origin(o, {}, {}, w), w});
        if (!si) {
            ++tally.lost;
            continue;
        }
        leave(scene, placed, *si, rng, tally);
        const Vec3 far = o + w * (20 * placement.scale);
        si = scene.intersect({offset_origin(far, {}, {}, -w), -w});
        if (!si) {
            ++tally.lost;
            continue;
        }
        leave(scene, placed, *si, rng, tally);
    }
    return tally;
}

TEST(SelfIntersection, ConvexBodiesAreLeftForGood) {
    const int rays = samples(1000);
    for (const Body& body : convex_bodies()) {
        for (const Placement& placement : placements(body)) {
            const Tally tally = leave_body(body, placement, rays);
            EXPECT_GT(tally.rays, rays / 2) << describe(body, placement);
            EXPECT_EQ(tally.hit_again, 0) << describe(body, placement);
            EXPECT_EQ(tally.lost, 0) << describe(body, placement);
            EXPECT_EQ(tally.near_side, 0) << describe(body, placement);
        }
    }
}

// The offset must clear the rounding, not more: what stands close must still be met.
TEST(SelfIntersection, OffsetsAreSmall) {
    Rng rng(3, 0, 0);
    for (const Body& body : convex_bodies()) {
        for (const Placement& placement : placements(body)) {
            const PlacedBody placed(body, placement, 1);
            const Scene scene(placed.description, {});
            const Vec3 w = random_direction(rng);
            const auto si = scene.intersect({offset_origin(placed.inside(rng), {}, {}, w), w});
            ASSERT_TRUE(si);
            // Roundings of the numbers at hand: position and extent, some dozen times.
            const double size = (placement.offset + 6) * placement.scale;
            EXPECT_LT(max_component(si->p_error), 200 * kFloatRounding * size) << describe(body, placement);
        }
    }
}

// What stands on a sphere of the earth's size, with the origin at its feet, must not be lost in the sphere's roundings.
TEST(SelfIntersection, PlanetsAreExactNearTheOrigin) {
    SceneBuilder b;
    b.sphere({0, 0, -6e6}, 6e6, b.diffuse(0.5));
    const Scene scene(b.scene(), {});
    Rng rng(5, 0, 0);
    for (int i = 0; i < samples(1000); ++i) {
        const Vec3 target{random_point(rng, 2).x, random_point(rng, 2).y, 0};
        const auto si = scene.intersect({{0, 0, 2}, normalize(target - Vec3{0, 0, 2})});
        ASSERT_TRUE(si);
        EXPECT_LT(max_component(si->p_error), 1e-6);
        // In double the distance to the centre is known to 1e-9.
        const Vec3 out = leaving_direction(rng, si->n_g, 1);
        EXPECT_FALSE(scene.intersect({offset_origin(si->p, si->p_error, si->n_g, out), out}));
        const Vec3 in = leaving_direction(rng, si->n_g, -1);
        EXPECT_TRUE(scene.intersect({offset_origin(si->p, si->p_error, si->n_g, in), in}));
    }
}

// A disk is seen from both sides: light shapes shine one way and block both.
TEST(SelfIntersection, DisksAreLeftForGood) {
    Rng rng(4, 0, 0);
    for (const Placement& placement : placements(convex_bodies().front())) {
        if (placement.instanced) continue;
        SceneBuilder b;
        LightDesc light;
        light.kind = LightKind::Disk;
        light.radius = 1;
        const Vec3 offset = random_direction(rng) * (placement.offset * placement.scale);
        light.world_from_light = random_affine(rng, placement.scale, offset, placement.mirrored);
        b.light(light);
        const Scene scene(b.scene(), {});
        const Transform world_from_light(light.world_from_light);
        for (int i = 0; i < samples(1000); ++i) {
            const Vec2 d = sample_concentric_disk(rng.next_2d());
            const Vec3 target = world_from_light.point({0.9 * d.x, 0.9 * d.y, 0});
            const Vec3 w = random_direction(rng);
            if (std::abs(dot(w, normalize(world_from_light.normal({0, 0, 1})))) < 0.01) continue;
            const Vec3 o = target - w * (3 * placement.scale);
            const auto si = scene.intersect({offset_origin(o, {}, {}, w), w});
            ASSERT_TRUE(si) << placement.scale << " " << placement.offset;
            for (double sign : {-1.0, 1.0}) {
                const Vec3 out = leaving_direction(rng, si->n_g, sign);
                EXPECT_FALSE(scene.intersect({offset_origin(si->p, si->p_error, si->n_g, out), out}))
                    << placement.scale << " " << placement.offset;
            }
        }
    }
}

}  // namespace
}  // namespace etendue::test
