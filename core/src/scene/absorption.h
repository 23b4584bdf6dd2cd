#pragma once

#include <cstddef>
#include <vector>

#include <etendue/scene_description.h>

#include "geometry/surface_interaction.h"
#include "math/rgb.h"
#include "scene/media.h"

namespace etendue {

/// What bodies absorb of the light inside them (Beer's law: exp(-mu d)). Where a segment runs is known by the surfaces
/// that its path has crossed, hence walks carry Media along. Densities know nothing of absorption: it is a factor of
/// the contribution alone.
class Absorption {
public:
    /// Throws SceneError when something absorbs and there are more kinds of bodies than a MediumId tells apart.
    explicit Absorption(const std::vector<MaterialDesc>& materials);

    /// False: everything is clear, and nobody needs to know in which body a point lies.
    [[nodiscard]] bool any() const { return any_; }

    /// The inside that the surface bounds; 0 when it bounds none, or nothing absorbs.
    [[nodiscard]] MediumId medium(const SurfaceInteraction& si) const {
        return si.material < 0 ? MediumId{0} : of_material_[static_cast<std::size_t>(si.material)];
    }
    /// The media on w's side of the surface, given those on wo's.
    [[nodiscard]] Media beyond(const Media& media, const SurfaceInteraction& si, const Vec3& wo, const Vec3& w) const;
    /// What is left after `distance` scene units, possibly infinitely many.
    [[nodiscard]] Rgb transmittance(const Media& media, double distance) const;

private:
    bool any_ = false;
    std::vector<MediumId> of_material_;
    std::vector<Rgb> coefficients_{Rgb()};  ///< mu, per scene unit, by medium
};

}  // namespace etendue
