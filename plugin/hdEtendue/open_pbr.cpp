#include <utility>

#include "surface_shaders.h"

namespace etendue::hydra {
namespace {

struct Switch {
    const char* input;
    Color off;
};

/// The inputs that switch on what is not rendered; the other inputs of these layers have no effect by themselves.
constexpr Switch kUnsupported[] = {
    {"specular_roughness_anisotropy", {0, 0, 0}},
    {"transmission_scatter", {0, 0, 0}},
    {"transmission_dispersion_scale", {0, 0, 0}},
    {"subsurface_weight", {0, 0, 0}},
    {"fuzz_weight", {0, 0, 0}},
    {"thin_film_weight", {0, 0, 0}},
};
/// Of a coat, when there is one.
constexpr Switch kUnsupportedOfCoat[] = {
    {"coat_color", {1, 1, 1}},
    {"coat_roughness_anisotropy", {0, 0, 0}},
    {"geometry_coat_normal", {0, 0, 1}},
};

void warn_of(const ShaderInputs& inputs, const Switch& layer) {
    if (!inputs.is_authored(layer.input, layer.off)) return;
    inputs.warn(std::string("open_pbr_surface ") + layer.input,
                std::string("open_pbr_surface input '") + layer.input + "' is not supported; rendered without it");
}

void warn_of_layers(const ShaderInputs& inputs, bool has_normal_map) {
    for (const Switch& layer : kUnsupported) warn_of(inputs, layer);
    if (!inputs.is_authored("coat_weight", 0.0)) return;
    for (const Switch& layer : kUnsupportedOfCoat) warn_of(inputs, layer);
    if (has_normal_map) {
        inputs.warn("open_pbr_surface coat over a normal map",
                    "open_pbr_surface: the map of geometry_normal bumps the coat as well");
    }
}

void warn_of_volume(const ShaderInputs& inputs, const OpenPbrMaterial& model) {
    const bool transmits = model.transmission_weight.texture >= 0 || model.transmission_weight.value > 0;
    if (transmits && !model.geometry_thin_walled && model.transmission_depth > 0 &&
        model.transmission_color.texture >= 0) {
        inputs.warn("open_pbr_surface textured volume",
                    "open_pbr_surface: a textured transmission_color tints the surface, whatever the "
                    "transmission_depth");
    }
}

OpenPbrMaterial read_model(ShaderInputs& inputs) {
    OpenPbrMaterial model;
    model.base_weight = inputs.number("base_weight", model.base_weight);
    model.base_color = inputs.color("base_color", model.base_color);
    model.base_diffuse_roughness = inputs.number("base_diffuse_roughness", model.base_diffuse_roughness);
    model.base_metalness = inputs.number("base_metalness", model.base_metalness);
    model.specular_weight = inputs.number("specular_weight", model.specular_weight);
    model.specular_color = inputs.color("specular_color", model.specular_color);
    model.specular_roughness = inputs.number("specular_roughness", model.specular_roughness);
    model.specular_ior = inputs.constant_number("specular_ior", model.specular_ior);
    model.transmission_weight = inputs.number("transmission_weight", model.transmission_weight);
    model.transmission_color = inputs.color("transmission_color", model.transmission_color);
    model.transmission_depth = inputs.constant_number("transmission_depth", model.transmission_depth);
    model.coat_weight = inputs.number("coat_weight", model.coat_weight);
    model.coat_roughness = inputs.number("coat_roughness", model.coat_roughness);
    model.coat_ior = inputs.constant_number("coat_ior", model.coat_ior);
    model.coat_darkening = inputs.number("coat_darkening", model.coat_darkening);
    model.geometry_opacity = inputs.number("geometry_opacity", model.geometry_opacity);
    model.geometry_thin_walled = inputs.constant_number("geometry_thin_walled", 0) != 0;
    return model;
}

}  // namespace

MaterialDesc read_open_pbr(ShaderInputs& inputs) {
    MaterialDesc desc;
    OpenPbrMaterial model = read_model(inputs);
    desc.normal_texture = inputs.normal_texture("geometry_normal");
    warn_of_volume(inputs, model);
    warn_of_layers(inputs, desc.normal_texture >= 0);
    const double luminance = inputs.constant_number("emission_luminance", 0);
    if (luminance != 0) desc.emission = inputs.color("emission_color", {{1, 1, 1}}, luminance);
    desc.model = std::move(model);
    return desc;
}

}  // namespace etendue::hydra
