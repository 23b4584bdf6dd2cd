#pragma once

#include <functional>
#include <vector>

#include "light/light_bounds.h"
#include "light/shaping.h"
#include "math/distribution.h"
#include "math/frame.h"

namespace etendue {

/// A shaped light's directions, chosen by what leaves along them: rings about the axis by their share of the power.
class Beam {
public:
    /// Area that the light shows towards w, which times radiance is radiant intensity; 1 for a point.
    using Silhouette = std::function<double(const Vec3& w)>;

    /// `front` is the normal of a light that has only one, else the axis again.
    Beam(const Shaping& shaping, const Vec3& front, const Silhouette& silhouette);

    [[nodiscard]] Rgb factor(const Vec3& w) const { return shaping_.factor(w); }
    /// Integral of the factor times the silhouette over all directions.
    [[nodiscard]] const Rgb& integral() const { return integral_; }
    /// The mean square of the factor over the squared mean: 1 for light all around, 1 / share of a cone.
    [[nodiscard]] double concentration() const { return concentration_; }
    [[nodiscard]] const Vec3& axis() const { return shaping_.axis(); }
    [[nodiscard]] double end() const { return shaping_.end(); }

    /// Needs an integral that is not black.
    [[nodiscard]] Vec3 sample(const Vec2& u) const;
    /// Per solid angle.
    [[nodiscard]] double pdf(const Vec3& w) const;

private:
    [[nodiscard]] double ring_pdf(std::size_t ring) const;

    Shaping shaping_;
    Frame frame_;
    std::vector<double> edges_;  ///< 1 - cos
    Distribution rings_;
    Rgb integral_;
    double concentration_ = 1;
};

/// Bounds of a light with the beam's cone instead of its normals', where that says more.
[[nodiscard]] LightBounds narrowed(LightBounds bounds, const Beam& beam);

}  // namespace etendue
