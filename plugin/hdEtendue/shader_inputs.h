#pragma once

#include <string>
#include <vector>

#include "material_network.h"
#include "textures.h"
#include "translation.h"

namespace etendue::hydra {

/// The inputs of one surface shader. Reading them collects the texture coordinates they need.
class ShaderInputs {
public:
    ShaderInputs(const Translation& translation, NodeRef shader)
        : translation_(translation), shader_(std::move(shader)) {}

    /// A colour in the rendering space; the default when nothing is authored. Both scaled.
    [[nodiscard]] ColorInput color(const std::string& name, const ColorInput& fallback, double multiplier = 1);
    /// A number; the default when nothing is authored.
    [[nodiscard]] FloatInput number(const std::string& name, const FloatInput& fallback);
    /// An input that may only be a constant; a connected one is warned about. Empty when nothing is authored.
    [[nodiscard]] VtValue constant(const std::string& name) const;
    [[nodiscard]] double constant_number(const std::string& name, double fallback) const;
    /// Index of the normal map connected to `name`, else -1.
    [[nodiscard]] int normal_texture(const std::string& name);
    /// Whether the input is connected to a node or set to something else than `fallback` in every component.
    [[nodiscard]] bool is_authored(const std::string& name, double fallback) const;
    [[nodiscard]] bool is_authored(const std::string& name, const Color& fallback) const;

    void warn(const std::string& kind, const std::string& message) const;
    [[nodiscard]] Warnings& warnings() const { return translation_.warnings; }
    /// Primvars of texture coordinates, in the order in which they were met.
    [[nodiscard]] const std::vector<std::string>& st_names() const { return st_names_; }

private:
    [[nodiscard]] InputSource resolve(const NodeRef& node, const std::string& name) const;
    [[nodiscard]] ColorInput constant_color(const std::string& name, const Constant& source, double multiplier,
                                            const ColorInput& fallback) const;
    void warn_of_node(const NodeOutput& source, const std::string& name) const;
    [[nodiscard]] TextureRead read(const NodeOutput& source, const TextureUse& use);

    Translation translation_;
    NodeRef shader_;
    std::vector<std::string> st_names_;
};

}  // namespace etendue::hydra
