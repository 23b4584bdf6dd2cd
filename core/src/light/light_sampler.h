#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "light/light.h"
#include "light/light_choice.h"
#include "light/light_tree.h"
#include "math/distribution.h"

namespace etendue {

/// Chooses among lights. Lights of zero power are never chosen.
class LightSampler {
public:
    /// `bounds` is what infinite lights were given: their power is that through its disk.
    LightSampler(const std::vector<std::unique_ptr<Light>>& lights, const SceneBounds& bounds);

    /// For a light subpath: by power. Empty when no light emits.
    [[nodiscard]] std::optional<LightChoice> sample_emission(double u) const;
    [[nodiscard]] double pmf_emission(int light) const;

    /// For next-event estimation at `receiver`: by what each light can send there, knowing nothing of what lies in
    /// between or of the surface; therefore sometimes blindly, half by power and half evenly, so that no light is
    /// starved by another that is nearer but hidden. Among few lights that is more often: there it is nearly as good
    /// (it wastes at most a factor of their number), while being wrong costs as much as ever. A single light is just
    /// taken. Empty when no light emits, or, sometimes, when none can light the receiver.
    [[nodiscard]] std::optional<LightChoice> sample_direct(const Vec3& receiver, double u) const;
    /// A function of the receiver alone, whichever way the light was found.
    [[nodiscard]] double pmf_direct(const Vec3& receiver, int light) const;

    [[nodiscard]] std::size_t memory_used() const {
        return emission_.memory_used() + blind_.memory_used() + tree_.memory_used() + by_irradiance_.memory_used();
    }

private:
    [[nodiscard]] std::optional<LightChoice> sample_aware(const Vec3& receiver, double u) const;
    [[nodiscard]] double pmf_aware(const Vec3& receiver, int light) const;
    [[nodiscard]] double tree_share(const Vec3& receiver) const;
    /// The whole probability, of what the aware choice gives the light.
    [[nodiscard]] double mixed(double aware, int light) const;

    Distribution emission_;
    Distribution blind_;
    double blind_share_ = 1;
    LightTree tree_;
    std::vector<int> boundless_;       ///< lights beside the tree: at infinity
    std::vector<int> boundless_slot_;  ///< by light; -1: in the tree, or dark
    Distribution by_irradiance_;       ///< over boundless_
};

}  // namespace etendue
