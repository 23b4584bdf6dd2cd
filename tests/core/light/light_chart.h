#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>

#include "core/light/light_cases.h"
#include "math/constants.h"
#include "math/frame.h"
#include "support/chi2.h"

namespace etendue::test {

/// Flattens a light's surface: x, y of a plane against points, with the world area per area of the plane. Densities on
/// it have no jump inside a cell. Triangles: [t, t + 1] x [0, 1] for triangle t. Disk: r^2, phi. Sphere: 1 -
/// cos(theta), phi about an axis of light space. Tube: height, angle from where a receiver begins to see it.
class LightChart {
public:
    /// The surface as sample_emission takes it.
    explicit LightChart(const LightCase& light_case) : case_(light_case) {
        if (is_sphere()) set_rings({0, 0, 1}, even_edges(0, 2, 16));
    }
    /// The surface with an edge of the cells where the part that `receiver` sees ends.
    LightChart(const LightCase& light_case, const Vec3& receiver) : LightChart(light_case) {
        if (!case_.quadric) return;
        const Vec3 seen = case_.quadric->parent_from_object.inverse_point(receiver) / case_.quadric->radius;
        if (is_tube()) {
            const double half_arc = std::acos(1 / std::hypot(seen.y, seen.z));
            first_phi_ = std::atan2(seen.z, seen.y) - half_arc;
            arcs_ = even_edges(0, 2 * half_arc, 11);
            arcs_.push_back(2 * kPi);
        }
        if (!is_sphere()) return;
        std::vector<double> edges = even_edges(0, 1 - 1 / length(seen), 12);
        edges.push_back(2);
        set_rings(normalize(seen), edges);
    }

    [[nodiscard]] Grid grid() const {
        if (is_sphere()) return {rings_, even_edges(0, 2 * kPi, 12)};
        if (is_tube()) return {even_edges(0, 1, 12), arcs_};
        if (case_.quadric) return {even_edges(0, 1, 12), even_edges(0, 2 * kPi, 12)};
        const auto count = static_cast<int>(case_.triangles.size());
        return {even_edges(0, count, 8 * count), even_edges(0, 1, 8)};
    }

    [[nodiscard]] Vec2 flat(const Vec3& p) const {
        if (!case_.quadric) return flat_triangle(p);
        const Vec3 o = case_.quadric->parent_from_object.inverse_point(p) / case_.quadric->radius;
        if (is_tube()) {
            const double turned = std::atan2(o.z, o.y) - first_phi_;
            return {std::clamp(o.x * case_.quadric->radius / (2 * case_.quadric->half_length) + 0.5, 0.0, 1.0),
                    turned - 2 * kPi * std::floor(turned / (2 * kPi))};
        }
        const Vec3 local = is_sphere() ? axis_.to_local(normalize(o)) : o;
        const double phi = std::atan2(local.y, local.x);
        const double x = is_sphere() ? 1 - local.z : std::min(1.0, o.x * o.x + o.y * o.y);
        return {std::clamp(x, 0.0, 2.0), phi < 0 ? phi + 2 * kPi : phi};
    }

    struct Place {
        LightPoint y;
        double area = 0;  ///< world per plane
    };
    [[nodiscard]] Place place(const Vec2& flat) const {
        if (is_sphere()) return place_sphere(flat);
        if (is_tube()) return place_tube(flat);
        return case_.quadric ? place_disk(flat) : place_triangle(flat);
    }

private:
    [[nodiscard]] bool is_sphere() const { return case_.quadric && case_.quadric->kind == QuadricKind::Sphere; }
    [[nodiscard]] bool is_tube() const { return case_.quadric && case_.quadric->kind == QuadricKind::Tube; }
    void set_rings(const Vec3& axis, std::vector<double> rings) {
        axis_ = Frame::from_normal(axis);
        rings_ = std::move(rings);
    }

    [[nodiscard]] Place place_sphere(const Vec2& flat) const {
        const double sin = std::sqrt(std::max(0.0, flat.x * (2 - flat.x)));
        const Vec3 n = axis_.to_world({sin * std::cos(flat.y), sin * std::sin(flat.y), 1 - flat.x});
        const double radius = case_.quadric->radius;
        const Transform& t = case_.quadric->parent_from_object;
        Place place;
        place.y.p = t.point(n * radius);
        place.y.n = normalize(t.normal(n));
        place.area = radius * radius * std::abs(t.determinant()) * length(t.normal(n));
        return place;
    }
    [[nodiscard]] Place place_tube(const Vec2& flat) const {
        const Quadric& q = *case_.quadric;
        const double length_along = 2 * q.half_length;
        const double phi = flat.y + first_phi_;
        const Vec3 n{0, std::cos(phi), std::sin(phi)};
        const Transform& t = q.parent_from_object;
        Place place;
        place.y.p = t.point({length_along * (flat.x - 0.5), q.radius * n.y, q.radius * n.z});
        place.y.n = normalize(t.normal(n));
        place.area = length_along * q.radius * std::abs(t.determinant()) * length(t.normal(n));
        return place;
    }
    [[nodiscard]] Place place_disk(const Vec2& flat) const {
        const double r = std::sqrt(flat.x) * case_.quadric->radius;
        const Transform& t = case_.quadric->parent_from_object;
        Place place;
        place.y.p = t.point({r * std::cos(flat.y), r * std::sin(flat.y), 0});
        place.y.n = case_.quadric->normal(place.y.p);
        const double unit_area = length(cross(t.vector({1, 0, 0}), t.vector({0, 1, 0})));
        place.area = unit_area * case_.quadric->radius * case_.quadric->radius / 2;  // r dr = d(r^2) / 2
        return place;
    }
    [[nodiscard]] Place place_triangle(const Vec2& flat) const {
        const std::size_t index = std::min(static_cast<std::size_t>(flat.x), case_.triangles.size() - 1);
        const LightTriangle& t = case_.triangles[index];
        const double both = std::sqrt(flat.x - static_cast<double>(index));  // b1 + b2
        const Vec3 e1 = t.p[1] - t.p[0];
        const Vec3 e2 = t.p[2] - t.p[0];
        Place place;
        place.y.p = t.p[0] + e1 * (both * (1 - flat.y)) + e2 * (both * flat.y);
        place.y.n = normalize(cross(e1, e2));
        place.area = length(cross(e1, e2)) / 2;
        return place;
    }
    [[nodiscard]] Vec2 flat_triangle(const Vec3& p) const {
        constexpr double kTolerance = 1e-6;  // traced corners are float
        for (std::size_t i = 0; i < case_.triangles.size(); ++i) {
            const LightTriangle& t = case_.triangles[i];
            const Vec3 e1 = t.p[1] - t.p[0];
            const Vec3 e2 = t.p[2] - t.p[0];
            const Vec3 n = cross(e1, e2);
            const double scale = 1 / length_squared(n);
            const Vec3 q = p - t.p[0];
            const double b1 = dot(cross(q, e2), n) * scale;
            const double b2 = dot(cross(e1, q), n) * scale;
            if (std::abs(dot(q, n)) * std::sqrt(scale) > kTolerance) continue;
            if (b1 < -kTolerance || b2 < -kTolerance || b1 + b2 > 1 + kTolerance) continue;
            const double both = std::clamp(b1 + b2, 1e-12, 1.0);
            return {static_cast<double>(i) + both * both, std::clamp(b2 / both, 0.0, 1.0)};
        }
        throw std::logic_error("a sampled point lies on no triangle");
    }

    const LightCase& case_;
    Frame axis_ = Frame::from_normal({0, 0, 1});
    std::vector<double> rings_;
    double first_phi_ = 0;
    std::vector<double> arcs_ = even_edges(0, 2 * kPi, 12);
};

}  // namespace etendue::test
