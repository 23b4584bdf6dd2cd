#pragma once

#include <vector>

#include <etendue/scene_description.h>

#include "math/rgb.h"
#include "math/vec.h"

namespace etendue {

/// How the radiance of a light varies with the direction in which it leaves, alike at all of its points: rings about
/// an axis (UsdLux' ShapingAPI).
class Shaping {
public:
    /// `axis` is unit.
    Shaping(const ShapingDesc& desc, const Vec3& axis) : desc_(desc), axis_(axis) {}

    [[nodiscard]] const Vec3& axis() const { return axis_; }
    /// Of light that leaves along the unit vector w, or at the angle `theta` from the axis.
    [[nodiscard]] Rgb factor(const Vec3& w) const;
    [[nodiscard]] Rgb factor(double theta) const;

    /// Angle from the axis beyond which nothing leaves, in [0, pi].
    [[nodiscard]] double end() const;
    /// Angles from 0 to end() that cut the factor into smooth and shallow pieces.
    [[nodiscard]] std::vector<double> rings() const;

private:
    ShapingDesc desc_;
    Vec3 axis_;
};

}  // namespace etendue
