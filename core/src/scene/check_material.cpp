#include "scene/check_material.h"

#include <string>
#include <variant>

#include <etendue/error.h>

#include "bsdf/material_fields.h"

namespace etendue {
namespace {

class Checker {
public:
    Checker(const std::string& name, std::size_t texture_count) : name_(name), count_(texture_count) {}

    void index(int texture) const {
        if (texture >= 0 && static_cast<std::size_t>(texture) >= count_) {
            throw SceneError(name_ + ": texture index " + std::to_string(texture) + " is out of range");
        }
    }
    void not_negative(const char* what, double value) const {
        if (!(value >= 0)) throw SceneError(name_ + ": " + what + " " + std::to_string(value) + " is not 0 or more");
    }

    void input(const ColorInput& color) const { index(color.texture); }
    void input(const FloatInput& number) const {
        index(number.texture);
        if (number.texture >= 0 && (number.channel < 0 || number.channel > 3)) {
            throw SceneError(name_ + ": texture channel " + std::to_string(number.channel) + " is out of range");
        }
    }

private:
    const std::string& name_;
    std::size_t count_;
};

/// What textures cannot vary.
template <typename Model>
void check(const Model&, const Checker&) {}
void check(const DielectricMaterial& m, const Checker& checker) {
    checker.not_negative("ior", m.ior);
    checker.not_negative("transmission_depth", m.transmission_depth);
}
void check(const PreviewSurfaceMaterial& m, const Checker& checker) { checker.not_negative("ior", m.ior); }
void check(const OpenPbrMaterial& m, const Checker& checker) {
    checker.not_negative("specular_ior", m.specular_ior);
    checker.not_negative("transmission_depth", m.transmission_depth);
    checker.not_negative("coat_ior", m.coat_ior);
}

}  // namespace

void check_material(const MaterialDesc& material, std::size_t texture_count) {
    const Checker checker(material.name, texture_count);
    for_each_input(material, [&](const auto& input) { checker.input(input); });
    checker.index(material.normal_texture);
    std::visit([&](const auto& model) { check(model, checker); }, material.model);
}

}  // namespace etendue
