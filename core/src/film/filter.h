#pragma once

#include <etendue/render_settings.h>

#include "math/vec.h"

namespace etendue {

/// A pixel filter as a probability density over offsets from the pixel's centre, in pixels. Camera rays are drawn from
/// it, splats are weighted by it: both then estimate the same pixel value.
class Filter {
public:
    /// Throws SettingsError when the radius is not positive.
    explicit Filter(const PixelFilter& filter);

    [[nodiscard]] Vec2 sample(const Vec2& u) const;
    /// Density, 1 / pixel area; integrates to one.
    [[nodiscard]] double eval(const Vec2& offset) const;
    [[nodiscard]] double radius() const { return radius_; }

private:
    FilterKind kind_;
    double radius_;
};

}  // namespace etendue
