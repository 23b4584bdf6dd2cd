#pragma once

#include <optional>

#include "math/transform.h"
#include "math/vec.h"

namespace etendue {

enum class QuadricKind { Sphere, Disk, Tube };

/// An exact sphere about the origin, a disk in the xy plane, or a cylinder about the x axis without its ends, under an
/// affine transform (so also ellipsoids and ellipses). The outward normal leaves the sphere and the cylinder's axis,
/// and is object space +z for a disk; `flipped` turns it round.
struct Quadric {
    QuadricKind kind = QuadricKind::Sphere;
    double radius = 1;
    bool flipped = false;  ///< a disk light shines along -z
    Transform parent_from_object;
    double half_length = 0;        ///< of a tube
    bool has_coordinates = false;  ///< whether anybody asks for st()

    /// Nearest t in (t_near, t_far) along origin + t direction (parent space).
    [[nodiscard]] std::optional<double> intersect(const Vec3& origin, const Vec3& direction, double t_near,
                                                  double t_far) const;
    /// The surface point nearest to `p`, which lies next to the surface; parent space.
    [[nodiscard]] Vec3 project(const Vec3& p) const;
    /// Outward unit normal; parent space.
    [[nodiscard]] Vec3 normal(const Vec3& p) const;
    /// Longitude and latitude of a sphere, polar coordinates of a disk, angle and height of a tube, each in [0, 1].
    [[nodiscard]] Vec2 st(const Vec3& p) const;

    /// Where its object space coordinates end.
    [[nodiscard]] Vec3 extent() const;

    struct Bounds {
        Vec3 lower;
        Vec3 upper;
    };
    [[nodiscard]] Bounds bounds() const;

    [[nodiscard]] bool operator==(const Quadric&) const = default;
};

}  // namespace etendue
