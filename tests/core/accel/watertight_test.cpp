// A ray cannot slip between two triangles that share an edge.

#include <gtest/gtest.h>

#include "core/accel/convex_bodies.h"
#include "geometry/triangle_mesh.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

/// Where rays are aimed: float decides which of the triangles that meet there, if any, is hit.
enum class Target { Edge, Corner };

int escapes(const Body& body, const Placement& placement, Target target, int rays) {
    const MeshDesc mesh = as_mesh(body.geometry);
    const TriangleMesh cut = make_triangle_mesh(mesh, {}, "/body");
    const PlacedBody placed({body.name, mesh}, placement, 1);
    const Scene scene(placed.description, {});
    Rng rng(2, 0, 0);
    int escaped = 0;
    for (int i = 0; i < rays; ++i) {
        const auto t = static_cast<std::size_t>(rng.next_1d() * static_cast<double>(cut.triangles.size()));
        const auto corner = static_cast<std::size_t>(rng.next_1d() * 3);
        const double along = target == Target::Corner ? 0 : 0.01 + 0.98 * rng.next_1d();
        const Vec3 from = cut.point(t, corner);
        const Vec3 to = cut.point(t, (corner + 1) % 3);
        if (from == to) continue;  // the seam of a pole
        const Vec3 o = placed.inside(rng);
        const Vec3 w = normalize(placed.world_from_body.point(from * (1 - along) + to * along) - o);
        if (!scene.intersect({offset_origin(o, {}, {}, w), w})) ++escaped;
        if (scene.sees_infinity(RayEnd::free(o), w)) ++escaped;
    }
    return escaped;
}

std::vector<Body> closed_meshes() {
    std::vector<Body> bodies = convex_bodies();
    bodies.push_back({"capsule", CapsuleDesc{0.7, 1, Axis::X}, true});
    return bodies;
}

TEST(Watertight, NothingEscapesThroughSharedEdges) {
    const int rays = samples(2000);
    for (const Body& body : closed_meshes()) {
        for (const Placement& placement : placements(body)) {
            EXPECT_EQ(escapes(body, placement, Target::Edge, rays), 0) << describe(body, placement);
        }
    }
}

// Embree's edge functions agree between two triangles, not all round a corner where many small ones meet. Only rays
// aimed within float's rounding of such a corner can tell; chance aims none.
TEST(Watertight, HardlyAnythingEscapesThroughCorners) {
    const int rays = samples(500);
    for (const Body& body : closed_meshes()) {
        for (const Placement& placement : placements(body)) {
            EXPECT_LE(escapes(body, placement, Target::Corner, rays), 2 + rays / 25) << describe(body, placement);
        }
    }
}

}  // namespace
}  // namespace etendue::test
