#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "light/make_light.h"
#include "scene/placed_shape.h"

namespace etendue {

/// What an earlier scene has put in place, for one that follows an edit to take over.
class KnownGeometry {
public:
    /// The shapes stay where they are.
    void add(const std::vector<PlacedShape>& shapes);
    /// To be called once all are added.
    void sort();

    /// Null unless it is known.
    [[nodiscard]] std::shared_ptr<const PlacedGeometry> find(const Placement& placement) const;
    /// Lights' own shapes are small: the one of that number is taken if it is the same, corner by corner.
    [[nodiscard]] std::shared_ptr<const PlacedGeometry> light_shape(std::size_t number, LightShape shape) const;

private:
    std::vector<const PlacedShape*> placed_;  ///< by the owner of their description
    std::vector<const PlacedShape*> light_shapes_;
};

}  // namespace etendue
