#pragma once

#include <variant>

#include <etendue/scene_description.h>

namespace etendue {

/// Calls visit(input) for each input of the model that a texture may feed: ColorInput or FloatInput.
template <typename Visit>
void for_each_input(const DiffuseMaterial& m, Visit&& visit) {
    visit(m.reflectance);
    visit(m.roughness);
}
template <typename Visit>
void for_each_input(const ConductorMaterial& m, Visit&& visit) {
    visit(m.reflectance);
    visit(m.roughness);
}
template <typename Visit>
void for_each_input(const DielectricMaterial& m, Visit&& visit) {
    visit(m.roughness);
    visit(m.reflection_tint);
    visit(m.transmission_tint);
}
template <typename Visit>
void for_each_input(const PreviewSurfaceMaterial& m, Visit&& visit) {
    visit(m.diffuse_color);
    visit(m.specular_color);
    visit(m.metallic);
    visit(m.roughness);
    visit(m.clearcoat);
    visit(m.clearcoat_roughness);
    visit(m.opacity);
}
template <typename Visit>
void for_each_input(const OpenPbrMaterial& m, Visit&& visit) {
    visit(m.base_weight);
    visit(m.base_color);
    visit(m.base_diffuse_roughness);
    visit(m.base_metalness);
    visit(m.specular_weight);
    visit(m.specular_color);
    visit(m.specular_roughness);
    visit(m.transmission_weight);
    visit(m.transmission_color);
    visit(m.coat_weight);
    visit(m.coat_roughness);
    visit(m.coat_darkening);
    visit(m.geometry_opacity);
}
template <typename Visit>
void for_each_input(const PhongMaterial& m, Visit&& visit) {
    visit(m.reflectance);
    visit(m.exponent);
}

/// Of its model and its emission. The normal map is none: it is no value that a texture replaces.
template <typename Visit>
void for_each_input(const MaterialDesc& material, Visit&& visit) {
    visit(material.emission);
    std::visit([&](const auto& model) { for_each_input(model, visit); }, material.model);
}

}  // namespace etendue
