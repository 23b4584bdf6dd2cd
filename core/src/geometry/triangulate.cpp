#include "geometry/triangulate.h"

#include <cstddef>

namespace etendue {
namespace {

/// Newell's method: the area vector, robust for slightly bent polygons.
Vec3 area_vector(std::span<const Vec3> corners) {
    Vec3 sum;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        sum += cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
    }
    return sum;
}

/// Clips ears off one polygon.
class EarClipper {
public:
    explicit EarClipper(std::span<const Vec3> corners) : corners_(corners), normal_(area_vector(corners)) {
        for (std::size_t i = 0; i < corners.size(); ++i) remaining_.push_back(static_cast<int>(i));
    }

    void run(std::vector<std::array<int, 3>>& triangles) {
        while (remaining_.size() > 3) {
            const std::size_t ear = find_ear();
            triangles.push_back(corner_triangle(ear));
            remaining_.erase(remaining_.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        triangles.push_back({remaining_[0], remaining_[1], remaining_[2]});
    }

private:
    [[nodiscard]] std::array<int, 3> corner_triangle(std::size_t i) const {
        const std::size_t n = remaining_.size();
        return {remaining_[(i + n - 1) % n], remaining_[i], remaining_[(i + 1) % n]};
    }
    [[nodiscard]] const Vec3& corner(int i) const { return corners_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] double turn(int a, int b, int c) const {
        return dot(normal_, cross(corner(b) - corner(a), corner(c) - corner(b)));
    }

    /// Corners in the same place do not count: a bridge to a hole is walked twice, and both its ends are repeated.
    [[nodiscard]] bool contains_another(const std::array<int, 3>& t) const {
        for (int i : remaining_) {
            if (corner(i) == corner(t[0]) || corner(i) == corner(t[1]) || corner(i) == corner(t[2])) continue;
            if (turn(t[0], t[1], i) >= 0 && turn(t[1], t[2], i) >= 0 && turn(t[2], t[0], i) >= 0) return true;
        }
        return false;
    }

    /// Index into `remaining_`; 1 (the fan's choice) when there is no ear.
    [[nodiscard]] std::size_t find_ear() const {
        // Starting at 1 makes a convex polygon a fan about its first corner.
        for (std::size_t k = 0; k < remaining_.size(); ++k) {
            const std::size_t i = (k + 1) % remaining_.size();
            const std::array<int, 3> t = corner_triangle(i);
            if (turn(t[0], t[1], t[2]) > 0 && !contains_another(t)) return i;
        }
        return 1;
    }

    std::span<const Vec3> corners_;
    Vec3 normal_;
    std::vector<int> remaining_;
};

}  // namespace

void triangulate_polygon(std::span<const Vec3> corners, std::vector<std::array<int, 3>>& triangles) {
    if (corners.size() == 3) {
        triangles.push_back({0, 1, 2});
        return;
    }
    EarClipper(corners).run(triangles);
}

}  // namespace etendue
