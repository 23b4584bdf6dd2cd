#include <utility>

#include "convert.h"
#include "surface_shaders.h"

namespace etendue::hydra {

MaterialDesc read_preview_surface(ShaderInputs& inputs) {
    PreviewSurfaceMaterial model;
    model.diffuse_color = inputs.color("diffuseColor", model.diffuse_color);
    model.use_specular_workflow = inputs.constant_number("useSpecularWorkflow", 0) != 0;
    model.specular_color = inputs.color("specularColor", model.specular_color);
    model.metallic = inputs.number("metallic", model.metallic);
    model.roughness = inputs.number("roughness", model.roughness);
    model.clearcoat = inputs.number("clearcoat", model.clearcoat);
    model.clearcoat_roughness = inputs.number("clearcoatRoughness", model.clearcoat_roughness);
    model.opacity = inputs.number("opacity", model.opacity);
    model.opacity_threshold = inputs.constant_number("opacityThreshold", model.opacity_threshold);
    model.ior = inputs.constant_number("ior", model.ior);
    // USD writes a token, MaterialX an integer.
    const std::string mode = text(inputs.constant("opacityMode"));
    if (mode == "presence" || mode == "1") {
        model.opacity_mode = PreviewOpacityMode::Presence;
    } else if (!mode.empty() && mode != "transparent" && mode != "0") {
        inputs.warn("opacityMode", "unknown opacityMode '" + mode + "'; 'transparent' is used");
    }
    MaterialDesc desc;
    desc.emission = inputs.color("emissiveColor", {});
    desc.normal_texture = inputs.normal_texture("normal");
    desc.model = std::move(model);
    return desc;
}

}  // namespace etendue::hydra
