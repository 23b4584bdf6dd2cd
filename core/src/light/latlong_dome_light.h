#pragma once

#include <memory>

#include "light/emission_table.h"
#include "light/infinite_light.h"
#include "math/frame.h"

namespace etendue {

/// A latlong image seen from inside, after OpenEXR's convention: of `dome`'s axes, the middle of the image is towards
/// n, a quarter of its width to the left of that towards s, and the top row is about t. Directions are chosen by the
/// image's brightness.
class LatlongDomeLight final : public InfiniteLight {
public:
    /// `dome` may be left-handed: a mirrored image. A black image has power 0, and nothing can be sampled from it.
    LatlongDomeLight(const SceneBounds& bounds, const Frame& dome, const Rgb& radiance,
                     std::shared_ptr<const EmissionImage> image);

    [[nodiscard]] Rgb radiance(const LightPoint& y, const Vec3& w) const override;
    [[nodiscard]] std::size_t memory_used() const override { return table_.memory_used(); }

protected:
    [[nodiscard]] DirectionSample sample_direction(const Vec2& u) const override;
    [[nodiscard]] double pdf_direction(const Vec3& to_light) const override;
    [[nodiscard]] Rgb fluence() const override { return radiance_ * table_.integral(); }

private:
    /// In the image, x to the right and y down, both in [0, 1].
    [[nodiscard]] Vec2 image_point(const Vec3& to_light) const;

    Frame dome_;
    Rgb radiance_;
    std::shared_ptr<const EmissionImage> image_;
    EmissionTable table_;
};

}  // namespace etendue
