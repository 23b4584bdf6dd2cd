#include "scene/known_geometry.h"

#include <algorithm>
#include <utility>

namespace etendue {
namespace {

using Description = std::weak_ptr<const GeometryDesc>;

struct Precedes {
    bool operator()(const PlacedShape* a, const PlacedShape* b) const { return before(a, b->placement->geometry); }
    bool operator()(const PlacedShape* a, const Description& b) const { return before(a, b); }
    bool operator()(const Description& a, const PlacedShape* b) const { return a.owner_before(b->placement->geometry); }

private:
    static bool before(const PlacedShape* a, const Description& b) { return a->placement->geometry.owner_before(b); }
};

}  // namespace

void KnownGeometry::add(const std::vector<PlacedShape>& shapes) {
    for (const PlacedShape& shape : shapes) (shape.placement ? placed_ : light_shapes_).push_back(&shape);
}

void KnownGeometry::sort() { std::sort(placed_.begin(), placed_.end(), Precedes{}); }

std::shared_ptr<const PlacedGeometry> KnownGeometry::find(const Placement& placement) const {
    const auto [first, last] = std::equal_range(placed_.begin(), placed_.end(), placement.geometry, Precedes{});
    const auto same = std::find_if(first, last, [&](const PlacedShape* shape) {
        return shape->placement->as_mesh == placement.as_mesh &&
               shape->placement->coordinates == placement.coordinates &&
               shape->placement->parent_from_object == placement.parent_from_object;
    });
    return same == last ? nullptr : (*same)->geometry;
}

std::shared_ptr<const PlacedGeometry> KnownGeometry::light_shape(std::size_t number, LightShape shape) const {
    if (number < light_shapes_.size() && *light_shapes_[number]->geometry == shape) {
        return light_shapes_[number]->geometry;
    }
    return std::make_shared<const PlacedGeometry>(std::move(shape));
}

}  // namespace etendue
