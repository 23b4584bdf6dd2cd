#pragma once

#include <vector>

#include "math/vec.h"

namespace etendue {

/// The facets of a surface, those of like direction added up: what it shows to a direction is soon told, however many
/// facets there are. Exact where no two directions fall together, else never more than the truth.
class AreaVectors {
public:
    AreaVectors();

    /// A facet's normal, as long as the facet's area.
    void add(const Vec3& facet);

    /// The area seen from afar along the unit vector w, fronts only, none of it hidden.
    [[nodiscard]] double seen_along(const Vec3& w) const;

private:
    std::vector<Vec3> sums_;  ///< by cell of a cube about the directions
};

}  // namespace etendue
