#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "light/area_light.h"
#include "light/emission_table.h"
#include "math/transform.h"

namespace etendue {

/// The image on a rect light, which is spread over all of it: its left edge at x = width / 2, its top at y = height /
/// 2, upright to who sees it shine. It multiplies the radiance, and points are chosen by it.
struct RectImage {
    std::shared_ptr<const EmissionImage> image;
    EmissionTable table;

    explicit RectImage(std::shared_ptr<const EmissionImage> texels)
        : image(std::move(texels)), table(*image, flat_rows(image->height()), false) {}
};

/// width x height in the XY plane of light space, centred; emits along -Z.
class RectLight final : public AreaLight {
public:
    /// A black image makes power 0, and nothing can be sampled from it.
    RectLight(const Transform& world_from_light, double width, double height, const Rgb& radiance,
              std::optional<RectImage> image = {});

    [[nodiscard]] static double world_area(const Transform& world_from_light, double width, double height);
    [[nodiscard]] std::optional<LightBounds> bounds() const override;
    [[nodiscard]] std::size_t memory_used() const override { return image_ ? image_->table.memory_used() : 0; }

protected:
    [[nodiscard]] PointSample sample_point(const Vec2& u) const override;
    [[nodiscard]] double pdf_point(const LightPoint& y) const override;
    [[nodiscard]] Rgb emitted(const LightPoint& y) const override;
    [[nodiscard]] Rgb mean_emitted() const override;
    [[nodiscard]] Beam::Silhouette silhouette() const override {
        return [this](const Vec3& w) { return area() * std::max(0.0, dot(n_, w)); };
    }
    [[nodiscard]] Vec3 flat_normal() const override { return n_; }

private:
    [[nodiscard]] double pdf_in(const EmissionTable::Cell& cell) const;

    Transform world_from_light_;
    Vec3 n_;
    double width_;
    double height_;
    std::optional<RectImage> image_;
};

}  // namespace etendue
