#include "light/area_vectors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace etendue {
namespace {

/// Cells along each edge of the cube. Within one directions differ by 15 degrees at most.
constexpr int kCells = 8;

std::size_t cell_of(const Vec3& v) {
    const Vec3 size = abs(v);
    int axis = size.x >= size.y ? 0 : 1;
    if (size[axis] < size.z) axis = 2;
    const auto along = [&](int other) {
        return std::clamp(static_cast<int>((v[other] / size[axis] + 1) / 2 * kCells), 0, kCells - 1);
    };
    const int face = 2 * axis + (v[axis] < 0 ? 1 : 0);
    return static_cast<std::size_t>((face * kCells + along((axis + 1) % 3)) * kCells + along((axis + 2) % 3));
}

}  // namespace

AreaVectors::AreaVectors() : sums_(static_cast<std::size_t>(6) * kCells * kCells) {}

void AreaVectors::add(const Vec3& facet) {
    if (facet == Vec3{}) return;
    sums_[cell_of(facet)] += facet;
}

double AreaVectors::seen_along(const Vec3& w) const {
    double area = 0;
    for (const Vec3& sum : sums_) area += std::max(0.0, dot(sum, w));
    return area;
}

}  // namespace etendue
