#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "light/light_bounds.h"
#include "light/light_choice.h"

namespace etendue {

/// A binary tree over lights with bounds, which chooses one with a probability that follows what it can send to a
/// receiver: intensity, distance, and whither it shines (Conty Estevez and Kulla 2018). A choice and its probability
/// both cost one walk from the root to a leaf.
class LightTree {
public:
    struct Item {
        int light = -1;  ///< index; each once
        LightBounds bounds;
        double power = 0;  ///< positive
    };

    LightTree() = default;
    explicit LightTree(std::vector<Item> items);

    [[nodiscard]] bool empty() const { return nodes_.empty(); }

    /// About what part of the light at the receiver is theirs, when other lights bring `irradiance`: all of them taken
    /// at the tree's middle distance. 0 only when none can light the receiver. Needs !empty().
    [[nodiscard]] double share_against(double irradiance, const Vec3& receiver) const;

    /// Empty when none can light the receiver.
    [[nodiscard]] std::optional<LightChoice> sample(const Vec3& receiver, double u) const;
    /// Of a light that is in the tree.
    [[nodiscard]] double pmf(const Vec3& receiver, int light) const;

    [[nodiscard]] std::size_t memory_used() const {
        return nodes_.capacity() * sizeof(Node) + trails_.capacity() * sizeof(std::uint64_t);
    }

private:
    struct Node {
        Vec3 center;
        Vec3 half;  ///< extent of the box
        Vec3 axis;
        double radius = 0;  ///< of the box
        double cos_normals = -1;
        double sin_normals = 0;
        double cos_emission = 0;
        double intensity = 0;     ///< sum of the lights' greatest, times any unit
        std::uint32_t child = 0;  ///< the first of two neighbours; 0: a leaf
        int light = -1;
    };
    struct Reach;
    struct Builder;

    [[nodiscard]] static Reach reach(const Node& node, const Vec3& receiver);
    /// Probability of the first child; negative when neither can light the receiver.
    [[nodiscard]] double first_share(const Node& parent, const Vec3& receiver) const;

    std::vector<Node> nodes_;            ///< the root first
    std::vector<std::uint64_t> trails_;  ///< by light: at each level from the root, lowest bit first, which child
};

}  // namespace etendue
