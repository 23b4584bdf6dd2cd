#include "light/mesh_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "light/area_vectors.h"
#include "light/point_error.h"
#include "math/constants.h"

namespace etendue {
namespace {

/// Twice the area, along the front's normal.
Vec3 area_vector(const LightTriangle& t) { return cross(t.p[1] - t.p[0], t.p[2] - t.p[0]); }

double triangle_area(const LightTriangle& t) { return length(area_vector(t)) / 2; }

Distribution areas(const std::vector<LightTriangle>& triangles) {
    std::vector<double> weights;
    weights.reserve(triangles.size());
    for (const LightTriangle& t : triangles) weights.push_back(triangle_area(t));
    return Distribution(weights);
}

}  // namespace

MeshLight::MeshLight(std::vector<LightTriangle> triangles, const Rgb& radiance,
                     std::shared_ptr<const EmissionTexture> texture)
    : AreaLight(radiance, world_area(triangles)),
      triangles_(std::move(triangles)),
      by_area_(areas(triangles_)),
      texture_(std::move(texture)),
      mean_emitted_(texture_ ? estimate_mean() : radiance) {}

double MeshLight::world_area(const std::vector<LightTriangle>& triangles) {
    double area = 0;
    for (const LightTriangle& t : triangles) area += triangle_area(t);
    return area;
}

AreaLight::PointSample MeshLight::sample_point(const Vec2& u) const {
    const Distribution::Sample choice = by_area_.sample(u.x);
    const LightTriangle& t = triangles_[choice.index];
    const Vec2 b = sample_uniform_triangle({choice.u, u.y});
    const double b0 = 1 - b.x - b.y;
    LightPoint y;
    y.p = t.p[0] * b0 + t.p[1] * b.x + t.p[2] * b.y;
    y.n = normalize(area_vector(t));
    y.st = {t.st[0].x * b0 + t.st[1].x * b.x + t.st[2].x * b.y, t.st[0].y * b0 + t.st[1].y * b.x + t.st[2].y * b.y};
    y.p_error = float_point_error(max(max(abs(t.p[0]), abs(t.p[1])), abs(t.p[2]))) + t.plane_error;
    return {y, pdf_point(y)};
}

Rgb MeshLight::emitted(const LightPoint& y) const {
    return texture_ ? base_radiance() * texture_->at(y.st) : base_radiance();
}

Beam::Silhouette MeshLight::silhouette() const {
    AreaVectors facets;
    for (const LightTriangle& t : triangles_) facets.add(area_vector(t) / 2);
    // The sums may miss the last facet that shines along w, and a beam the edge of a flat mesh that leans.
    const double least = 1e-3 * area();
    return [facets = std::move(facets), least](const Vec3& w) { return std::max(least, facets.seen_along(w)); };
}

Rgb MeshLight::estimate_mean() const {
    constexpr int kPoints = 1024;
    // Evenly spread points: the R2 sequence of Roberts (2018).
    constexpr double kAlphaX = 0.7548776662466927;
    constexpr double kAlphaY = 0.5698402909980532;
    Rgb sum;
    for (int i = 0; i < kPoints; ++i) {
        const double x = (i + 0.5) * kAlphaX;
        const double y = (i + 0.5) * kAlphaY;
        sum += emitted(sample_point({x - std::floor(x), y - std::floor(y)}).y);
    }
    // Light that all points missed must not be lost: keep a little of the untextured.
    const double floor = 1e-3 * max_component(base_radiance());
    const Rgb mean = sum / kPoints;
    return max_component(mean) > 0 || floor == 0 ? mean : Rgb(floor);
}

std::optional<LightBounds> MeshLight::bounds() const {
    LightBounds bounds{triangles_[0].p[0], triangles_[0].p[0]};
    Vec3 front;
    for (const LightTriangle& t : triangles_) {
        for (const Vec3& p : t.p) {
            bounds.lower = min(bounds.lower, p);
            bounds.upper = max(bounds.upper, p);
        }
        front += area_vector(t);
    }
    if (!(length(front) > 0)) return shaped_bounds(bounds);
    bounds.axis = normalize(front);
    bounds.cos_normals = 1;
    for (const LightTriangle& t : triangles_) {
        if (!(triangle_area(t) > 0)) continue;
        bounds.cos_normals = std::min(bounds.cos_normals, dot(bounds.axis, normalize(area_vector(t))));
    }
    return shaped_bounds(bounds);
}

}  // namespace etendue
