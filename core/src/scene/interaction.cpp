#include "scene/interaction.h"

#include <algorithm>
#include <cmath>

#include "geometry/plane_roundings.h"

namespace etendue {
namespace {

struct Corners {
    Vec3 p0;
    Vec3 e1;
    Vec3 e2;
};

void set_coordinates(const TriangleMesh& mesh, std::size_t triangle, const Corners& c, const AccelHit& hit,
                     SurfaceInteraction& si) {
    const Float2 a = mesh.corner_st(triangle, 0);
    const Float2 b = mesh.corner_st(triangle, 1);
    const Float2 d = mesh.corner_st(triangle, 2);
    const Vec2 s1{double{b[0]} - a[0], double{b[1]} - a[1]};
    const Vec2 s2{double{d[0]} - a[0], double{d[1]} - a[1]};
    si.st = {a[0] + hit.u * s1.x + hit.v * s2.x, a[1] + hit.u * s1.y + hit.v * s2.y};
    if (!mesh.has_tangents) return;
    const double determinant = s1.x * s2.y - s1.y * s2.x;
    if (determinant == 0) return;
    si.dpds = (c.e1 * s2.y - c.e2 * s1.y) / determinant;
    si.dpdt = (c.e2 * s1.x - c.e1 * s2.x) / determinant;
}

Vec3 shading_normal(const TriangleMesh& mesh, std::size_t triangle, const AccelHit& hit, const Vec3& n_g) {
    if (mesh.normals.empty()) return n_g;
    const Vec3 n = mesh.corner_normal(triangle, 0) * (1 - hit.u - hit.v) + mesh.corner_normal(triangle, 1) * hit.u +
                   mesh.corner_normal(triangle, 2) * hit.v;
    const double size = length(n);
    return size > 0 ? n / size : n_g;
}

/// Embree computes in float with the triangle's corners relative to the ray: its surface and ours lie apart by a few
/// roundings of the position and, more of a needle, of the triangle's own extent.
Vec3 triangle_error(const Corners& c, const Vec3& p, double twice_area) {
    const Vec3 d = p - c.p0;
    const Vec3 reach = max(max(abs(d), abs(c.e1 - d)), abs(c.e2 - d));
    const double extent = max_component(reach);
    const double of_plane = extent * plane_roundings(c.e1, c.e2, twice_area);
    return (abs(p) * 4 + Vec3(of_plane, of_plane, of_plane)) * kFloatRounding;
}

SurfaceInteraction interact(const TriangleMesh& mesh, const Ray& ray, const AccelHit& hit) {
    const std::size_t triangle = hit.primitive;
    const Vec3 p0 = mesh.point(triangle, 0);
    const Corners c{p0, mesh.point(triangle, 1) - p0, mesh.point(triangle, 2) - p0};
    SurfaceInteraction si;
    si.p = c.p0 + c.e1 * hit.u + c.e2 * hit.v;
    const Vec3 area = cross(c.e1, c.e2) * mesh.outward;
    const double size = length(area);
    si.p_error = triangle_error(c, si.p, size);
    si.n_g = size > 0 ? area / size : -ray.direction;  // a needle that only Embree could hit has no normal
    si.n_s = shading_normal(mesh, triangle, hit, si.n_g);
    if (!mesh.st.empty()) set_coordinates(mesh, triangle, c, hit, si);
    return si;
}

SurfaceInteraction interact(const Quadric& quadric, const Ray& ray, const AccelHit& hit) {
    SurfaceInteraction si;
    // The float distance only says which root was hit; the point is put back on the exact surface.
    si.p = quadric.project(ray.origin + ray.direction * hit.t);
    // Its own roundings are a double's; a float holds the ray's origin only. The ground on a planet stays in touch.
    si.p_error = quadric.parent_from_object.magnitude(quadric.extent()) * 0x1p-48 + abs(si.p) * (2 * kFloatRounding);
    si.n_g = quadric.normal(si.p);
    si.n_s = si.n_g;
    if (quadric.has_coordinates) si.st = quadric.st(si.p);
    return si;
}

}  // namespace

SurfaceInteraction interact(const PlacedGeometry& geometry, const Ray& ray, const AccelHit& hit) {
    return std::visit([&](const auto& g) { return interact(g, ray, hit); }, geometry);
}

int hit_slot(const PlacedGeometry& geometry, const AccelHit& hit) {
    const auto* mesh = std::get_if<TriangleMesh>(&geometry);
    return mesh == nullptr ? 0 : mesh->material_slot(hit.primitive);
}

void to_world(const Transform& world_from_group, SurfaceInteraction& si) {
    // Embree carries the ray into the group with a float matrix; its roundings come back through the transform.
    const Vec3 world_p = world_from_group.point(si.p);
    const Vec3 group_error = si.p_error + world_from_group.inverse().magnitude(world_p) * (4 * kFloatRounding);
    si.p_error = world_from_group.vector_magnitude(group_error) + abs(world_p) * (4 * kFloatRounding);
    si.p = world_p;
    si.n_g = normalize(world_from_group.normal(si.n_g));
    si.n_s = normalize(world_from_group.normal(si.n_s));
    si.dpds = world_from_group.vector(si.dpds);
    si.dpdt = world_from_group.vector(si.dpdt);
}

}  // namespace etendue
