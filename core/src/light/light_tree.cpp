#include "light/light_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/sampling.h"

namespace etendue {
namespace {

double clamped_sin(double cos) { return std::sqrt(std::max(0.0, 1 - cos * cos)); }

/// A vector of the plane with an angle in [0, pi] to the x axis, of any length.
struct Angle {
    double cos;
    double sin;
};

/// max(0, a - b), of length |a| |b|; b is less than pi.
Angle minus(const Angle& a, const Angle& b, double lengths) {
    const double sin = a.sin * b.cos - a.cos * b.sin;
    return sin < 0 ? Angle{lengths, 0} : Angle{a.cos * b.cos + a.sin * b.sin, sin};
}

}  // namespace

// ------------------------------------------------------------------------------------------------------- choosing

/// What a node can send to a receiver.
struct LightTree::Reach {
    double intensity = 0;  ///< greatest towards the receiver
    double nearest2 = 0;   ///< distance to the box, squared
    double farthest2 = 0;  ///< to its farthest corner
};

LightTree::Reach LightTree::reach(const Node& node, const Vec3& receiver) {
    const Vec3 from_center = receiver - node.center;
    const Vec3 distance = abs(from_center);
    const double nearest2 = length_squared(max(distance - node.half, Vec3{}));
    const double farthest2 = length_squared(distance + node.half);
    const double d2 = length_squared(from_center);
    const double r2 = node.radius * node.radius;
    if (node.cos_normals <= -1 || d2 <= r2) return {node.intensity, nearest2, farthest2};
    // The least angle between a normal of the cone and a direction from the box's sphere to the receiver; lengths d, d,
    // d^2.
    const double along = dot(node.axis, from_center);
    const Angle axis{along, std::sqrt(std::max(0.0, d2 - along * along))};
    const Angle normal = minus(axis, {node.cos_normals, node.sin_normals}, std::sqrt(d2));
    const Angle least = minus(normal, {std::sqrt(d2 - r2), node.radius}, d2);
    if (least.cos <= node.cos_emission * d2) return {0, nearest2, farthest2};
    return {node.intensity * least.cos / d2, nearest2, farthest2};
}

double LightTree::first_share(const Node& parent, const Vec3& receiver) const {
    const Reach a = reach(nodes_[parent.child], receiver);
    const Reach b = reach(nodes_[parent.child + 1], receiver);
    if (!(a.intensity > 0)) return b.intensity > 0 ? 0 : -1;
    if (!(b.intensity > 0)) return 1;
    // I_a / d_a^2 : I_b / d_b^2 for the nearest each can be and for the farthest, evenly mixed (Lin and Yuksel 2020): a
    // receiver inside a cluster expects it to hold the light that matters most.
    const double a_near = a.intensity * b.nearest2;
    const double b_near = b.intensity * a.nearest2;
    const double a_far = a.intensity * b.farthest2;
    const double b_far = b.intensity * a.farthest2;
    const double far = a_far + b_far > 0 ? a_far / (a_far + b_far) : 0.5;
    const double both = a_near + b_near;
    return both > 0 ? 0.5 * (a_near / both + far) : far;
}

double LightTree::share_against(double irradiance, const Vec3& receiver) const {
    const Reach root = reach(nodes_[0], receiver);
    if (!(root.intensity > 0)) return 0;
    const double middle2 = 0.5 * (root.nearest2 + root.farthest2);
    return root.intensity / (root.intensity + irradiance * middle2);
}

std::optional<LightChoice> LightTree::sample(const Vec3& receiver, double u) const {
    const Node* node = &nodes_[0];
    if (node->child == 0) return LightChoice{node->light, 1};
    double pmf = 1;
    while (node->child != 0) {
        const double first = first_share(*node, receiver);
        if (first < 0) return {};
        const bool second = u >= first;
        const double share = second ? 1 - first : first;
        u = std::min((second ? u - first : u) / share, kOneMinusEpsilon);
        pmf *= share;
        node = &nodes_[node->child + (second ? 1 : 0)];
    }
    return LightChoice{node->light, pmf};
}

double LightTree::pmf(const Vec3& receiver, int light) const {
    const Node* node = &nodes_[0];
    std::uint64_t trail = trails_[static_cast<std::size_t>(light)];
    double pmf = 1;
    for (; node->child != 0 && pmf > 0; trail >>= 1) {
        const double first = first_share(*node, receiver);
        if (first < 0) return 0;
        const bool second = (trail & 1) != 0;
        pmf *= second ? 1 - first : first;
        node = &nodes_[node->child + (second ? 1 : 0)];
    }
    return pmf;
}

// ------------------------------------------------------------------------------------------------------- building

/// Splits by the surface area orientation heuristic, along the axis and into the bins where it is least.
struct LightTree::Builder {
    static constexpr int kBins = 12;
    /// Deeper than this, halves are even in number: trails must hold every level.
    static constexpr int kFreeLevels = 30;

    struct Bin {
        std::optional<LightBounds> bounds;
        double power = 0;

        void add(const LightBounds& other, double other_power) {
            bounds = bounds ? enclose(*bounds, other) : other;
            power += other_power;
        }
        void add(const Bin& other) {
            if (other.bounds) add(*other.bounds, other.power);
        }
        /// Squared extent instead of area: lamps in a row have extent, but no area.
        [[nodiscard]] double cost() const {
            return bounds ? power * bounds->emission_measure() * bounds->diagonal_squared() : 0;
        }
    };
    struct Split {
        int axis = -1;
        int bin = 0;  ///< the last of the first half
        double cost = 0;
    };

    std::vector<Node>& nodes;
    std::vector<std::uint64_t>& trails;
    std::vector<Item>& items;

    [[nodiscard]] static int bin_of(const Item& item, const LightBounds& centers, int axis) {
        const double extent = centers.upper[axis] - centers.lower[axis];
        const double at = (item.bounds.center()[axis] - centers.lower[axis]) / extent;
        return std::clamp(static_cast<int>(at * kBins), 0, kBins - 1);
    }

    void try_axis(std::size_t begin, std::size_t end, const LightBounds& centers, int axis, Split& best) const {
        std::array<Bin, kBins> bins;
        for (std::size_t i = begin; i < end; ++i) {
            bins[static_cast<std::size_t>(bin_of(items[i], centers, axis))].add(items[i].bounds, items[i].power);
        }
        std::array<Bin, kBins> after = bins;
        for (std::size_t i = kBins - 1; i-- > 0;) after[i].add(after[i + 1]);
        // Long thin boxes are cut across.
        const Vec3 size = centers.upper - centers.lower;
        const double regularity = max_component(size) / size[axis];
        Bin before;
        for (std::size_t i = 0; i + 1 < kBins; ++i) {
            before.add(bins[i]);
            const double cost = regularity * (before.cost() + after[i + 1].cost());
            if (best.axis < 0 || cost < best.cost) best = {axis, static_cast<int>(i), cost};
        }
    }

    /// Where the second half begins; neither is empty.
    [[nodiscard]] std::size_t split(std::size_t begin, std::size_t end, int level) {
        const std::size_t middle = begin + (end - begin) / 2;
        LightBounds centers{items[begin].bounds.center(), items[begin].bounds.center()};
        for (std::size_t i = begin; i < end; ++i) {
            centers.lower = min(centers.lower, items[i].bounds.center());
            centers.upper = max(centers.upper, items[i].bounds.center());
        }
        Split best;
        for (int axis = 0; axis < 3 && level < kFreeLevels; ++axis) {
            if (centers.upper[axis] > centers.lower[axis]) try_axis(begin, end, centers, axis, best);
        }
        if (best.axis < 0) return middle;
        const auto at = [this](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
        const auto second = std::partition(
            at(begin), at(end), [&](const Item& item) { return bin_of(item, centers, best.axis) <= best.bin; });
        const auto cut = static_cast<std::size_t>(second - items.begin());
        return cut == begin || cut == end ? middle : cut;
    }

    LightBounds build(std::size_t index, std::size_t begin, std::size_t end, std::uint64_t trail, int level) {
        LightBounds bounds = items[begin].bounds;
        if (end - begin == 1) {
            nodes[index].light = items[begin].light;
            // Of the narrowest cones the measure rounds to 0, and an infinite share is none at all.
            nodes[index].intensity = items[begin].power / std::max(bounds.emission_measure(), 1e-14);
            trails[static_cast<std::size_t>(items[begin].light)] = trail;
        } else {
            const std::size_t cut = split(begin, end, level);
            const std::size_t child = nodes.size();
            nodes.resize(child + 2);
            const LightBounds first = build(child, begin, cut, trail, level + 1);
            const LightBounds second = build(child + 1, cut, end, trail | (std::uint64_t{1} << level), level + 1);
            bounds = enclose(first, second);
            nodes[index].child = static_cast<std::uint32_t>(child);
            nodes[index].intensity = nodes[child].intensity + nodes[child + 1].intensity;
        }
        set_bounds(nodes[index], bounds);
        return bounds;
    }

    static void set_bounds(Node& node, const LightBounds& bounds) {
        node.center = bounds.center();
        node.half = (bounds.upper - bounds.lower) * 0.5;
        node.radius = length(node.half);
        node.axis = bounds.axis;
        node.cos_normals = bounds.cos_normals;
        node.sin_normals = clamped_sin(bounds.cos_normals);
        node.cos_emission = bounds.cos_emission;
    }
};

LightTree::LightTree(std::vector<Item> items) {
    if (items.empty()) return;
    int last = 0;
    for (const Item& item : items) last = std::max(last, item.light);
    trails_.resize(static_cast<std::size_t>(last) + 1);
    nodes_.reserve(2 * items.size());
    nodes_.resize(1);
    Builder{nodes_, trails_, items}.build(0, 0, items.size(), 0, 0);
}

}  // namespace etendue
