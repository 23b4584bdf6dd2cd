#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "light/light.h"
#include "math/sphere.h"

namespace etendue {

/// Sends light subpaths more often towards what gathers light into caustics, which camera paths hardly find, and which
/// a small body seldom catches of a lamp that shines all around (transport.md §7). Every light is sampled by a mixture
/// of its own density and one over spheres: cones of directions from a point, disks across the direction from
/// infinity. Lights know nothing of it; without spheres nothing changes.
class EmissionAim {
public:
    static constexpr std::size_t kMostTargets = 6;

    EmissionAim() = default;
    /// At most kMostTargets. Densities stay exact wherever the spheres are.
    explicit EmissionAim(const std::vector<Sphere>& targets);

    [[nodiscard]] bool has_targets() const { return count_ > 0; }

    [[nodiscard]] EmissionSample sample(const Light& light, const Vec2& u_point, const Vec2& u_dir) const;
    /// Of y, and of leaving it along w through x; from infinity, where y is a direction, x says which of the parallel
    /// rays it is.
    [[nodiscard]] EmissionPdf pdf(const Light& light, const LightPoint& y, const Vec3& w, const Vec3& x) const;

private:
    struct Target {
        Vec3 center;         ///< the cone's axis, unit; from infinity, the sphere's centre
        double size2 = 0;    ///< |w - axis|^2 of the cone's edge, or the disk's radius squared
        double density = 0;  ///< one over its solid angle, or area
        double share = 0;    ///< of the mixture
    };
    /// The spheres as one light point sees them.
    struct Aimed {
        std::array<Target, kMostTargets> targets;
        std::size_t count = 0;
        double share = 0;  ///< of all targets together; the rest is the light's own

        [[nodiscard]] const Target& choose(double& u) const;
        void settle(double caught);
    };

    [[nodiscard]] Aimed aim(const Light& light, const LightPoint& y, double own_pdf) const;
    [[nodiscard]] Aimed aim_from_point(const Light& light, const LightPoint& y) const;
    [[nodiscard]] Aimed aim_from_infinity(double own_pdf) const;
    [[nodiscard]] static double mixed_pdf(const Aimed& aimed, bool infinite, double own_pdf, const Vec3& w,
                                          const Vec3& x);
    [[nodiscard]] static EmissionSample sample_target(const Light& light, const EmissionSample& own,
                                                      const Target& target, const Vec2& u);

    std::array<Sphere, kMostTargets> spheres_;
    std::size_t count_ = 0;
};

}  // namespace etendue
