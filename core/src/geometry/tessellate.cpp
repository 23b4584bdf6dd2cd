#include "geometry/tessellate.h"

#include <cmath>
#include <vector>

#include "math/constants.h"
#include "math/vec.h"

namespace etendue {
namespace {

constexpr int kSegments = 64;
constexpr int kCapRings = 16;

/// A point of a profile that turns about +z, with the normal of the surface there.
struct ProfilePoint {
    double r;
    double z;
    double n_r;
    double n_z;
};

Float3 to_axis(double along, double u, double v, Axis axis) {
    const auto a = static_cast<float>(along);
    const auto b = static_cast<float>(u);
    const auto c = static_cast<float>(v);
    switch (axis) {
        case Axis::X:
            return {a, b, c};
        case Axis::Y:
            return {c, a, b};
        case Axis::Z:
            break;
    }
    return {b, c, a};
}

/// Adds the surface of revolution of a profile that runs from low to high z; outward normals, smooth.
void add_revolution(MeshDesc& mesh, const std::vector<ProfilePoint>& profile, Axis axis) {
    const auto first = static_cast<std::int32_t>(mesh.points.size());
    constexpr int kColumns = kSegments + 1;  // the seam's column is doubled for its texture coordinate
    for (std::size_t row = 0; row < profile.size(); ++row) {
        const ProfilePoint& p = profile[row];
        for (int i = 0; i < kColumns; ++i) {
            const double phi = 2 * kPi * (i % kSegments) / kSegments;
            mesh.points.push_back(to_axis(p.z, p.r * std::cos(phi), p.r * std::sin(phi), axis));
            mesh.normals.push_back(to_axis(p.n_z, p.n_r * std::cos(phi), p.n_r * std::sin(phi), axis));
            mesh.st.push_back(
                {static_cast<float>(i) / kSegments, static_cast<float>(row) / static_cast<float>(profile.size() - 1)});
        }
    }
    const auto add_face = [&mesh](std::initializer_list<std::int32_t> corners) {
        mesh.face_vertex_counts.push_back(static_cast<std::int32_t>(corners.size()));
        mesh.face_vertex_indices.insert(mesh.face_vertex_indices.end(), corners);
    };
    for (std::size_t row = 0; row + 1 < profile.size(); ++row) {
        for (int i = 0; i < kSegments; ++i) {
            const std::int32_t a = first + static_cast<std::int32_t>(row) * kColumns + i;
            const std::int32_t b = a + kColumns;
            if (profile[row].r == 0) {
                add_face({a, b + 1, b});
            } else if (profile[row + 1].r == 0) {
                add_face({a, a + 1, b});
            } else {
                add_face({a, a + 1, b + 1, b});
            }
        }
    }
}

/// A flat disk at z facing along sign * z.
void add_cap(MeshDesc& mesh, double radius, double z, double sign, Axis axis) {
    const ProfilePoint rim{radius, z, 0, sign};
    const ProfilePoint center{0, z, 0, sign};
    if (sign < 0) {
        add_revolution(mesh, {center, rim}, axis);
    } else {
        add_revolution(mesh, {rim, center}, axis);
    }
}

/// Appends an arc of a circle of radius r about (0, z) from angle `from` to `to`, measured from the equator.
void add_arc(std::vector<ProfilePoint>& profile, double radius, double z, double from, double to) {
    for (int i = 0; i <= kCapRings; ++i) {
        const double angle = from + (to - from) * i / kCapRings;
        const bool pole = std::abs(std::abs(angle) - kPi / 2) < 1e-9;
        const double c = pole ? 0 : std::cos(angle);
        profile.push_back({radius * c, z + radius * std::sin(angle), c, std::sin(angle)});
    }
}

void add_quad(MeshDesc& mesh, const Vec3& center, const Vec3& half_u, const Vec3& half_v) {
    const auto first = static_cast<std::int32_t>(mesh.points.size());
    const auto add = [&mesh](const Vec3& p, float s, float t) {
        mesh.points.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
        mesh.st.push_back({s, t});
    };
    add(center - half_u - half_v, 0, 0);
    add(center + half_u - half_v, 1, 0);
    add(center + half_u + half_v, 1, 1);
    add(center - half_u + half_v, 0, 1);
    mesh.face_vertex_counts.push_back(4);
    mesh.face_vertex_indices.insert(mesh.face_vertex_indices.end(), {first, first + 1, first + 2, first + 3});
}

}  // namespace

MeshDesc tessellate(const SphereDesc& sphere) {
    MeshDesc mesh;
    std::vector<ProfilePoint> profile;
    add_arc(profile, sphere.radius, 0, -kPi / 2, 0);
    profile.pop_back();
    add_arc(profile, sphere.radius, 0, 0, kPi / 2);
    add_revolution(mesh, profile, Axis::Z);
    return mesh;
}

MeshDesc tessellate(const CubeDesc& cube) {
    MeshDesc mesh;
    const double h = cube.size / 2;
    const Vec3 x{h, 0, 0};
    const Vec3 y{0, h, 0};
    const Vec3 z{0, 0, h};
    add_quad(mesh, x, y, z);
    add_quad(mesh, -x, z, y);
    add_quad(mesh, y, z, x);
    add_quad(mesh, -y, x, z);
    add_quad(mesh, z, x, y);
    add_quad(mesh, -z, y, x);
    return mesh;
}

MeshDesc tessellate(const PlaneDesc& plane) {
    MeshDesc mesh;
    const double w = plane.width / 2;
    const double l = plane.length / 2;
    // UsdGeomPlane: width runs along x (along z for axis X), length along y (along z for axis Y).
    switch (plane.axis) {
        case Axis::X:
            add_quad(mesh, {}, {0, l, 0}, {0, 0, w});
            break;
        case Axis::Y:
            add_quad(mesh, {}, {0, 0, l}, {w, 0, 0});
            break;
        case Axis::Z:
            add_quad(mesh, {}, {w, 0, 0}, {0, l, 0});
            break;
    }
    return mesh;
}

MeshDesc tessellate(const CylinderDesc& cylinder) {
    MeshDesc mesh;
    const double h = cylinder.height / 2;
    const double r = cylinder.radius;
    add_revolution(mesh, {{r, -h, 1, 0}, {r, h, 1, 0}}, cylinder.axis);
    add_cap(mesh, r, -h, -1, cylinder.axis);
    add_cap(mesh, r, h, 1, cylinder.axis);
    return mesh;
}

MeshDesc tessellate(const ConeDesc& cone) {
    MeshDesc mesh;
    const double h = cone.height / 2;
    const double r = cone.radius;
    const double slant = std::hypot(r, cone.height);
    const double n_r = cone.height / slant;
    const double n_z = r / slant;
    add_revolution(mesh, {{r, -h, n_r, n_z}, {0, h, n_r, n_z}}, cone.axis);
    add_cap(mesh, r, -h, -1, cone.axis);
    return mesh;
}

MeshDesc tessellate(const CapsuleDesc& capsule) {
    MeshDesc mesh;
    std::vector<ProfilePoint> profile;
    add_arc(profile, capsule.radius, -capsule.height / 2, -kPi / 2, 0);
    add_arc(profile, capsule.radius, capsule.height / 2, 0, kPi / 2);
    add_revolution(mesh, profile, capsule.axis);
    return mesh;
}

}  // namespace etendue
