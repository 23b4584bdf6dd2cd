#pragma once

#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "core/math/random_math.h"
#include "geometry/tessellate.h"
#include "geometry/triangle_mesh.h"
#include "scene/scene.h"
#include "support/scene_builder.h"

namespace etendue::test {

/// A convex body about the origin that holds the ball of radius 0.2 and lies within that of radius 3.
struct Body {
    const char* name;
    GeometryDesc geometry;
    bool narrow_faces = false;
};

inline MeshDesc octahedron() {
    MeshDesc mesh;
    mesh.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.face_vertex_counts.assign(8, 3);
    mesh.face_vertex_indices = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    return mesh;
}

inline std::vector<Body> convex_bodies() {
    return {{"octahedron", octahedron()},
            {"cube", CubeDesc{2}},
            {"low_polygon_sphere", low_polygon_sphere(7, 5, false)},
            {"smooth_polygon_sphere", low_polygon_sphere(7, 5, true)},
            {"cylinder", CylinderDesc{1, 2, Axis::Y}, true},
            {"cone", ConeDesc{1, 2, Axis::Z}, true},
            {"sphere", SphereDesc{1}}};
}

inline MeshDesc as_mesh(const GeometryDesc& geometry) {
    return std::visit(
        [](const auto& g) {
            if constexpr (std::is_same_v<std::decay_t<decltype(g)>, MeshDesc>) {
                return g;
            } else {
                return tessellate(g);
            }
        },
        geometry);
}

/// Where a body stands, how large it is, and how it got there.
struct Placement {
    double scale = 1;
    double offset = 0;  ///< distance from the origin over the scale
    bool instanced = false;
    bool mirrored = false;
};

inline std::string describe(const Body& body, const Placement& p) {
    return std::string(body.name) + " scale " + std::to_string(std::log10(p.scale)) + " offset " +
           std::to_string(p.offset) + (p.instanced ? " instanced" : "") + (p.mirrored ? " mirrored" : "");
}

/// Far from the origin the points of narrow quads, rounded to float, bend them inwards by more than any offset clears:
/// the body is no longer convex. Instances keep their points in their own space.
inline std::vector<Placement> placements(const Body& body) {
    std::vector<Placement> all;
    for (double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
        for (double offset : {0.0, 10.0, 1000.0}) {
            for (bool instanced : {false, true}) {
                if (body.narrow_faces && offset > 0 && !instanced) continue;
                all.push_back({scale, offset, instanced, false});
                all.push_back({scale, offset, instanced, true});
            }
        }
    }
    return all;
}

/// The body, sheared and turned, as the only thing in a scene; `world_from_body` is where its points went.
struct PlacedBody {
    Transform world_from_body;
    SceneDescription description;

    PlacedBody(const Body& body, const Placement& p, std::uint64_t seed) {
        Rng rng(seed, 0, 0);
        const Vec3 offset = random_direction(rng) * (p.offset * p.scale);
        SceneBuilder b;
        const int grey = b.diffuse(0.5);
        if (p.instanced) {
            // Half of the way within the group, half by the instance.
            const Matrix4 inner = random_affine(rng, std::sqrt(p.scale), {}, false);
            const Matrix4 outer = random_affine(rng, std::sqrt(p.scale), offset, p.mirrored);
            world_from_body = Transform(outer) * Transform(inner);
            b.scene().geometries.emplace_back(body.geometry);
            b.scene().groups = {{"/group", {{"/group/body", 0, {grey}, inner}}}};
            b.scene().instances = {{"/instance", 0, outer}};
        } else {
            const Matrix4 placed = random_affine(rng, p.scale, offset, p.mirrored);
            world_from_body = Transform(placed);
            b.shape(body.geometry, grey, placed);
        }
        description = b.scene();
        add_planes(body);
    }

    /// Whether the point lies farther from the body's edges than its own error reaches: nearer, an offset may cross
    /// the neighbouring face.
    [[nodiscard]] bool clear_of_edges(const SurfaceInteraction& si) const {
        const double reach = dot(abs(si.n_g), si.p_error);
        const Vec3 within = si.p - si.n_g * (16 * reach);
        for (const auto& [p, n] : planes_) {
            if (dot(within - p, n) > -8 * reach) return false;
        }
        return true;
    }

    /// A point well inside.
    [[nodiscard]] Vec3 inside(Rng& rng) const { return world_from_body.point(random_point(rng, 0.1)); }

private:
    struct Plane {
        Vec3 p;
        Vec3 n;  ///< outwards
    };

    void add_planes(const Body& body) {
        if (std::holds_alternative<SphereDesc>(body.geometry)) return;  // no edges
        const TriangleMesh mesh = make_triangle_mesh(as_mesh(body.geometry), {}, body.name);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const Vec3 n = cross(mesh.point(t, 1) - mesh.point(t, 0), mesh.point(t, 2) - mesh.point(t, 0));
            if (length(n) < 1e-12) continue;
            planes_.push_back(
                {world_from_body.point(mesh.point(t, 0)), normalize(world_from_body.normal(normalize(n)))});
        }
    }

    std::vector<Plane> planes_;
};

/// At a random angle to the surface, every order of magnitude of grazing; against n when `sign` is negative.
inline Vec3 leaving_direction(Rng& rng, const Vec3& n, double sign) {
    const double cosine = rng.next_1d() < 0.5 ? rng.next_1d() : std::pow(10, -6 * rng.next_1d());
    const double phi = 2 * kPi * rng.next_1d();
    const double sine = std::sqrt(1 - cosine * cosine);
    const Frame frame = Frame::from_normal(n);
    return frame.to_world({sine * std::cos(phi), sine * std::sin(phi), sign * cosine});
}

}  // namespace etendue::test
