#include "scene/check_material.h"

#include <string>
#include <variant>

#include <etendue/error.h>

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
    template <typename... Inputs>
    void inputs(const Inputs&... all) const {
        (input(all), ...);
    }
    void not_negative(const char* what, double value) const {
        if (!(value >= 0)) throw SceneError(name_ + ": " + what + " " + std::to_string(value) + " is not 0 or more");
    }

private:
    void input(const ColorInput& color) const { index(color.texture); }
    void input(const FloatInput& number) const {
        index(number.texture);
        if (number.texture >= 0 && (number.channel < 0 || number.channel > 3)) {
            throw SceneError(name_ + ": texture channel " + std::to_string(number.channel) + " is out of range");
        }
    }

    const std::string& name_;
    std::size_t count_;
};

void check(const DiffuseMaterial& m, const Checker& checker) { checker.inputs(m.reflectance, m.roughness); }
void check(const ConductorMaterial& m, const Checker& checker) { checker.inputs(m.reflectance, m.roughness); }
void check(const DielectricMaterial& m, const Checker& checker) {
    checker.inputs(m.roughness, m.reflection_tint, m.transmission_tint);
    checker.not_negative("ior", m.ior);
    checker.not_negative("transmission_depth", m.transmission_depth);
}
void check(const PreviewSurfaceMaterial& m, const Checker& checker) {
    checker.inputs(m.diffuse_color, m.specular_color, m.metallic, m.roughness, m.clearcoat, m.clearcoat_roughness,
                   m.opacity);
    checker.not_negative("ior", m.ior);
}
void check(const OpenPbrMaterial& m, const Checker& checker) {
    checker.inputs(m.base_weight, m.base_color, m.base_diffuse_roughness, m.base_metalness, m.specular_weight,
                   m.specular_color, m.specular_roughness, m.transmission_weight, m.transmission_color, m.coat_weight,
                   m.coat_roughness, m.coat_darkening, m.geometry_opacity);
    checker.not_negative("specular_ior", m.specular_ior);
    checker.not_negative("transmission_depth", m.transmission_depth);
    checker.not_negative("coat_ior", m.coat_ior);
}

void check(const PhongMaterial& m, const Checker& checker) { checker.inputs(m.reflectance, m.exponent); }

}  // namespace

void check_material(const MaterialDesc& material, std::size_t texture_count) {
    const Checker checker(material.name, texture_count);
    checker.inputs(material.emission);
    checker.index(material.normal_texture);
    std::visit([&](const auto& model) { check(model, checker); }, material.model);
}

}  // namespace etendue
