#include "bsdf/lobes.h"

#include <algorithm>
#include <variant>

#include "bsdf/ggx.h"
#include "bsdf/material_inputs.h"

namespace etendue {
namespace {

bool may_exceed(const FloatInput& input, double bound) { return input.texture >= 0 || input.value > bound; }
bool may_be_below(const FloatInput& input, double bound) { return input.texture >= 0 || !(input.value >= bound); }
bool may_reflect(const ColorInput& input) {
    return input.texture >= 0 || std::any_of(input.value.begin(), input.value.end(), [](double c) { return c > 0; });
}

bool may_be_smooth(const FloatInput& roughness) {
    return roughness.texture >= 0 || !(roughness.value > 0) || roughness.value * roughness.value < kSmoothAlpha;
}
bool may_be_rough(const FloatInput& roughness) {
    return roughness.texture >= 0 || (roughness.value > 0 && roughness.value * roughness.value >= kSmoothAlpha);
}

void add_reflection(const FloatInput& roughness, LobeSet& lobes) {
    lobes.smooth_reflection |= may_be_smooth(roughness);
    lobes.rough_reflection |= may_be_rough(roughness);
}

void add_glass(const FloatInput& roughness, LobeSet& lobes) {
    add_reflection(roughness, lobes);
    lobes.smooth_transmission |= may_be_smooth(roughness);
    lobes.rough_transmission |= may_be_rough(roughness);
}

void add(const DiffuseMaterial&, LobeSet& lobes) { lobes.diffuse = true; }
void add(const ConductorMaterial& m, LobeSet& lobes) { add_reflection(m.roughness, lobes); }
void add(const DielectricMaterial& m, LobeSet& lobes) { add_glass(m.roughness, lobes); }
void add(const PhongMaterial&, LobeSet& lobes) { lobes.rough_reflection = true; }

void add(const PreviewSurfaceMaterial& m, LobeSet& lobes) {
    const bool all_metal = !m.use_specular_workflow && m.metallic.texture < 0 && m.metallic.value >= 1;
    const double ior = usable_ior(m.ior);
    lobes.diffuse |= !all_metal;
    const bool metal = !m.use_specular_workflow && may_exceed(m.metallic, 0);
    if (metal || (m.use_specular_workflow ? may_reflect(m.specular_color) : ior != 1)) {
        add_reflection(m.roughness, lobes);
    }
    if (may_exceed(m.clearcoat, 0) && ior != 1) add_reflection(m.clearcoat_roughness, lobes);
    if (m.opacity_threshold > 0) {
        lobes.cutout |= may_be_below(m.opacity, m.opacity_threshold);
    } else if (may_be_below(m.opacity, 1)) {
        (m.opacity_mode == PreviewOpacityMode::Presence ? lobes.cutout : lobes.smooth_transmission) = true;
    }
}

void add(const OpenPbrMaterial& m, LobeSet& lobes) {
    const bool opaque = may_be_below(m.base_metalness, 1) && may_be_below(m.transmission_weight, 1);
    lobes.diffuse |= opaque;
    const bool metal = may_exceed(m.base_metalness, 0);
    const bool interface = may_exceed(m.specular_weight, 0) && usable_ior(m.specular_ior) != 1;
    if (metal || interface) add_reflection(m.specular_roughness, lobes);
    if (may_exceed(m.transmission_weight, 0)) add_glass(m.specular_roughness, lobes);
    if (may_exceed(m.coat_weight, 0) && usable_ior(m.coat_ior) != 1) add_reflection(m.coat_roughness, lobes);
    lobes.cutout |= may_be_below(m.geometry_opacity, 1);
}

}  // namespace

LobeSet possible_lobes(const MaterialDesc& material) {
    LobeSet lobes;
    std::visit([&](const auto& model) { add(model, lobes); }, material.model);
    return lobes;
}

}  // namespace etendue
