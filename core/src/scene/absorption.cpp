#include "scene/absorption.h"

#include <cmath>
#include <limits>
#include <optional>

#include <etendue/error.h>

#include "bsdf/interior.h"

namespace etendue {
namespace {

/// Clear even infinitely far, where there is nothing to absorb.
double left(double mu, double distance) { return mu > 0 ? std::exp(-mu * distance) : 1; }

}  // namespace

Absorption::Absorption(const std::vector<MaterialDesc>& materials) : of_material_(materials.size()) {
    std::vector<std::optional<Rgb>> insides;
    for (const MaterialDesc& material : materials) {
        insides.push_back(interior_absorption(material));
        if (insides.back() && !is_black(*insides.back())) any_ = true;
    }
    if (!any_) return;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        if (!insides[i]) continue;
        if (coefficients_.size() > std::numeric_limits<MediumId>::max()) {
            throw SceneError(materials[i].name + ": too many transparent materials");
        }
        of_material_[i] = static_cast<MediumId>(coefficients_.size());
        coefficients_.push_back(*insides[i]);
    }
}

Media Absorption::beyond(const Media& media, const SurfaceInteraction& si, const Vec3& wo, const Vec3& w) const {
    const MediumId id = medium(si);
    const double side = dot(w, si.n_g);
    if (id == 0 || (side > 0) == (dot(wo, si.n_g) > 0)) return media;
    Media out = media;
    if (side > 0) {
        out.leave(id);
    } else {
        out.enter(id);
    }
    return out;
}

Rgb Absorption::transmittance(const Media& media, double distance) const {
    const Rgb& mu = coefficients_[media.innermost()];
    return {left(mu.r, distance), left(mu.g, distance), left(mu.b, distance)};
}

}  // namespace etendue
