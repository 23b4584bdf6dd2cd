#include "scene/casters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "bsdf/material.h"
#include "math/rng.h"

namespace etendue {
namespace {

// ---------------------------------------------------------------------------------------------------- materials

/// Narrow means this dense, per steradian: a diffuse surface reaches 1 / pi, metal of roughness 0.37 about 4.
constexpr double kNarrowDensity = 4;
/// The coat of a plastic sends some 5 % on in a narrow bundle; no one looks for its caustics.
constexpr double kLeastNarrow = 0.25;

/// A direction that has not changed: a hole in the surface, which gathers nothing.
bool straight(const Vec3& wo, const Vec3& wi) { return length_squared(wo + wi) < 1e-9; }

/// What part of the light from 45 degrees goes on in narrow bundles.
double narrow_part(const Bsdf& bsdf, Rng& rng) {
    constexpr int kTries = 32;
    const Vec3 wo = normalize({1, 0, 1});
    double sum = 0;
    for (int i = 0; i < kTries; ++i) {
        const double u_lobe = rng.next_1d();
        const auto sample = bsdf.sample(wo, u_lobe, rng.next_2d(), TransportMode::Importance, {});
        if (!sample || straight(wo, sample->wi)) continue;
        if (sample->delta || sample->pdf_fwd >= kNarrowDensity) sum += max_component(sample->weight);
    }
    return sum / kTries;
}

bool sends_in_one_direction(const Bsdf& bsdf, Rng& rng) {
    constexpr int kTries = 256;  // the coat of a plastic is chosen once in twenty tries
    const Vec3 wo = normalize({1, 0, 1});
    for (int i = 0; i < kTries; ++i) {
        const double u_lobe = rng.next_1d();
        const auto sample = bsdf.sample(wo, u_lobe, rng.next_2d(), TransportMode::Importance, {});
        if (sample && sample->delta) return true;
    }
    return false;
}

/// Textured materials are tried here and there.
constexpr std::array<Vec2, 4> kPlaces{Vec2{0.13, 0.29}, Vec2{0.41, 0.83}, Vec2{0.67, 0.37}, Vec2{0.89, 0.61}};

Bsdf bsdf_at(const MaterialDesc& material, const TextureSet& textures, const Vec2& st) {
    SurfaceInteraction si;
    si.n_g = si.n_s = {0, 0, 1};
    si.st = st;
    return make_bsdf(material, textures, si);
}

// ------------------------------------------------------------------------------------------------------- shapes

bool is_caster(const PlacedShape& shape, std::size_t slot, const std::vector<bool>& focusing) {
    const int material = shape.materials[slot];
    return material >= 0 && focusing[static_cast<std::size_t>(material)];
}

/// Calls visit(corner) for all corners of the triangles in these slots.
template <typename Visit>
void for_each_corner(const TriangleMesh& mesh, const std::vector<bool>& slots, Visit&& visit) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!slots[static_cast<std::size_t>(mesh.material_slot(t))]) continue;
        for (std::size_t corner = 0; corner < 3; ++corner) visit(mesh.point(t, corner));
    }
}

Sphere around(const TriangleMesh& mesh, const std::vector<bool>& slots) {
    std::optional<AccelBounds> box;
    for_each_corner(mesh, slots, [&box](const Vec3& p) {
        box = box ? AccelBounds{min(box->lower, p), max(box->upper, p)} : AccelBounds{p, p};
    });
    if (!box) return {};
    Sphere sphere{(box->lower + box->upper) * 0.5, 0};
    for_each_corner(mesh, slots,
                    [&sphere](const Vec3& p) { sphere.radius = std::max(sphere.radius, length(p - sphere.center)); });
    return sphere;
}

Sphere around(const Quadric& quadric, const std::vector<bool>& slots) {
    return slots[0] ? transformed({{}, quadric.radius}, quadric.parent_from_object) : Sphere{};
}

}  // namespace

bool focuses(const MaterialDesc& material, const TextureSet& textures) {
    Rng rng(1, 0, 0);
    double sum = 0;
    for (const Vec2& st : kPlaces) sum += narrow_part(bsdf_at(material, textures, st), rng);
    return sum >= kLeastNarrow * kPlaces.size();
}

bool has_delta_lobe(const MaterialDesc& material, const TextureSet& textures) {
    Rng rng(1, 0, 0);
    return std::any_of(kPlaces.begin(), kPlaces.end(),
                       [&](const Vec2& st) { return sends_in_one_direction(bsdf_at(material, textures, st), rng); });
}

Sphere transformed(const Sphere& sphere, const Transform& transform) {
    // M stretches by the root of the greatest eigenvalue of M^T M, which its rows' sums bound (Gershgorin): exactly,
    // for a sphere that stays one.
    const std::array<Vec3, 3> columns{transform.vector({1, 0, 0}), transform.vector({0, 1, 0}),
                                      transform.vector({0, 0, 1})};
    double stretch2 = 0;
    for (const Vec3& a : columns) {
        double sum = 0;
        for (const Vec3& b : columns) sum += abs_dot(a, b);
        stretch2 = std::max(stretch2, sum);
    }
    return {transform.point(sphere.center), sphere.radius * std::sqrt(stretch2)};
}

std::vector<Sphere> find_casters(const std::vector<PlacedShape>& shapes, const std::vector<bool>& focusing) {
    std::vector<Sphere> casters;
    for (const PlacedShape& shape : shapes) {
        std::vector<bool> slots;
        for (std::size_t slot = 0; slot < shape.materials.size(); ++slot) {
            slots.push_back(is_caster(shape, slot, focusing));
        }
        if (std::find(slots.begin(), slots.end(), true) == slots.end()) continue;
        const Sphere sphere =
            std::visit([&](const auto& geometry) { return around(geometry, slots); }, *shape.geometry);
        if (sphere.radius > 0) casters.push_back(sphere);
    }
    return casters;
}

// ----------------------------------------------------------------------------------------------------- clusters

namespace {

/// Beyond this many, neighbours are put together first, cell by cell: pairs are too many to compare.
constexpr std::size_t kMostPaired = 64;

std::vector<Sphere> pooled_in_cells(const std::vector<Sphere>& spheres) {
    constexpr int kCells = 4;  // along each axis
    Vec3 lower = spheres[0].center;
    Vec3 upper = lower;
    for (const Sphere& s : spheres) {
        lower = min(lower, s.center);
        upper = max(upper, s.center);
    }
    const auto cell_of = [&](const Vec3& p, int axis) {
        const double extent = upper[axis] - lower[axis];
        return extent > 0 ? std::min(kCells - 1, static_cast<int>((p[axis] - lower[axis]) / extent * kCells)) : 0;
    };
    std::array<std::optional<Sphere>, static_cast<std::size_t>(kCells) * kCells * kCells> cells;
    for (const Sphere& s : spheres) {
        const int cell = (cell_of(s.center, 0) * kCells + cell_of(s.center, 1)) * kCells + cell_of(s.center, 2);
        std::optional<Sphere>& pool = cells[static_cast<std::size_t>(cell)];
        pool = pool ? enclose(*pool, s) : s;
    }
    std::vector<Sphere> pools;
    for (const auto& pool : cells) {
        if (pool) pools.push_back(*pool);
    }
    return pools;
}

/// What aiming at one instead of two costs, or gains.
double growth(const Sphere& a, const Sphere& b) {
    const double radius = enclose(a, b).radius;
    return radius * radius - a.radius * a.radius - b.radius * b.radius;
}

}  // namespace

std::vector<Sphere> cluster(std::vector<Sphere> spheres, std::size_t count) {
    if (spheres.size() > kMostPaired) spheres = pooled_in_cells(spheres);
    while (spheres.size() > 1) {
        std::pair<std::size_t, std::size_t> best{0, 1};
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            for (std::size_t j = i + 1; j < spheres.size(); ++j) {
                if (growth(spheres[i], spheres[j]) < growth(spheres[best.first], spheres[best.second])) best = {i, j};
            }
        }
        const auto [i, j] = best;
        if (spheres.size() <= count && growth(spheres[i], spheres[j]) > 0) break;
        spheres[i] = enclose(spheres[i], spheres[j]);
        spheres.erase(spheres.begin() + static_cast<std::ptrdiff_t>(j));
    }
    return spheres;
}

}  // namespace etendue
