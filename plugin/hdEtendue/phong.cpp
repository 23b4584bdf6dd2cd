#include <utility>

#include "convert.h"
#include "surface_shaders.h"

namespace etendue::hydra {

MaterialDesc read_phong(ShaderInputs& inputs) {
    PhongMaterial model;
    model.reflectance = inputs.color("reflectance", model.reflectance);
    model.exponent = inputs.number("exponent", model.exponent);
    const std::string form = text(inputs.constant("form"));
    if (form == "classic") {
        model.form = PhongForm::Classic;
    } else if (!form.empty() && form != "modified") {
        inputs.warn("Phong form", "unknown form '" + form + "'; 'modified' is used");
    }
    MaterialDesc desc;
    desc.normal_texture = inputs.normal_texture("normal");
    desc.model = std::move(model);
    return desc;
}

}  // namespace etendue::hydra
