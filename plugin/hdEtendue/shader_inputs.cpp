#include "shader_inputs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "color_spaces.h"
#include "convert.h"

namespace etendue::hydra {
namespace {

/// The channel that an output names, -1 when it is the whole colour.
int channel_of(const std::string& output) {
    if (output.size() != 1) return -1;
    const std::size_t channel = std::string("rgba").find(output);
    return channel == std::string::npos ? -1 : static_cast<int>(channel);
}

ColorInput scaled(const ColorInput& input, double multiplier) {
    return {{input.value[0] * multiplier, input.value[1] * multiplier, input.value[2] * multiplier}, -1};
}

bool reads_primvar(const std::string& type) {
    return type.starts_with("UsdPrimvarReader_") || type.starts_with("ND_UsdPrimvarReader_") ||
           type.starts_with("ND_geompropvalue_");
}

/// The input that a node passes on: of a primvar reader what stands in for the primvar.
std::string constant_of(const std::string& type) {
    if (type.starts_with("ND_constant_")) return "value";
    return type.starts_with("ND_geompropvalue_") ? "default" : "fallback";
}

bool departs(const std::vector<double>& values, const Color& fallback) {
    for (std::size_t i = 0; i < std::min<std::size_t>(values.size(), 3); ++i) {
        if (std::abs(values[i] - fallback[i]) > 1e-6) return true;
    }
    return false;
}

}  // namespace

ColorInput ShaderInputs::color(const std::string& name, const ColorInput& fallback, double multiplier) {
    const InputSource source = resolve(shader_, name);
    if (const auto* constant = std::get_if<Constant>(&source)) {
        return constant_color(name, *constant, multiplier, fallback);
    }
    const auto* output = std::get_if<NodeOutput>(&source);
    if (output == nullptr) return scaled(fallback, multiplier);
    if (!is_texture(output->node)) {
        warn_of_node(*output, name);
        return scaled(fallback, multiplier);
    }
    if (channel_of(output->output) >= 0) {
        warn("channel as color " + shader_.type() + "." + name, "input '" + name +
                                                                    "' is a colour connected to the single channel '" +
                                                                    output->output + "'; the texture's rgb is used");
    }
    const TextureRead texture = read(*output, {.multiplier = multiplier});
    if (texture.index < 0) return {{texture.fallback[0], texture.fallback[1], texture.fallback[2]}, -1};
    return {{}, texture.index};
}

FloatInput ShaderInputs::number(const std::string& name, const FloatInput& fallback) {
    const InputSource source = resolve(shader_, name);
    if (const auto* constant = std::get_if<Constant>(&source)) return {number_or(constant->value, fallback.value)};
    const auto* output = std::get_if<NodeOutput>(&source);
    if (output == nullptr) return fallback;
    if (!is_texture(output->node)) {
        warn_of_node(*output, name);
        return fallback;
    }
    const TextureRead texture = read(*output, {});
    const int channel = std::max(channel_of(output->output), 0);
    if (texture.index < 0) return {texture.fallback[static_cast<std::size_t>(channel)]};
    return {0, texture.index, channel};
}

VtValue ShaderInputs::constant(const std::string& name) const {
    return constant_input(translation_.warnings, shader_, name);
}

double ShaderInputs::constant_number(const std::string& name, double fallback) const {
    return number_or(constant(name), fallback);
}

int ShaderInputs::normal_texture(const std::string& name) {
    InputSource source = resolve(shader_, name);
    if (!std::holds_alternative<NodeOutput>(source)) return -1;
    const bool unpack = std::get<NodeOutput>(source).node.type().starts_with("ND_normalmap");
    if (unpack) {
        source = resolve(std::get<NodeOutput>(source).node, "in");
        if (!std::holds_alternative<NodeOutput>(source)) return -1;
    }
    const auto& output = std::get<NodeOutput>(source);
    if (!is_texture(output.node)) {
        warn_of_node(output, name);
        return -1;
    }
    return read(output, {.data = true, .unpack_normal = unpack}).index;
}

bool ShaderInputs::is_authored(const std::string& name, double fallback) const {
    return is_authored(name, Color{fallback, fallback, fallback});
}

bool ShaderInputs::is_authored(const std::string& name, const Color& fallback) const {
    const InputSource source = resolve(shader_, name);
    if (const auto* constant = std::get_if<Constant>(&source)) return departs(numbers(constant->value), fallback);
    return std::holds_alternative<NodeOutput>(source);
}

void ShaderInputs::warn(const std::string& kind, const std::string& message) const {
    translation_.warnings.warn(kind, shader_.path, message);
}

/// resolve_input through the nodes that only pass a constant on.
InputSource ShaderInputs::resolve(const NodeRef& node, const std::string& name) const {
    InputSource source = resolve_input(node, name);
    for (std::size_t rest = node.network->nodes.size(); rest > 0; --rest) {
        const auto* output = std::get_if<NodeOutput>(&source);
        if (output == nullptr) return source;
        const std::string& type = output->node.type();
        const bool reader = reads_primvar(type);
        if (!reader && !type.starts_with("ND_constant_")) return source;
        if (reader) {
            translation_.warnings.warn("primvar reader " + shader_.type() + "." + name, output->node.path,
                                       "input '" + name +
                                           "' reads a primvar, which is supported for texture coordinates only; the "
                                           "reader's fallback is used");
        }
        const NodeRef upstream = output->node;
        source = resolve_input(upstream, constant_of(type));
    }
    translation_.warnings.warn("ring of nodes " + node.path.GetString(), node.path,
                               "the nodes of input '" + name + "' feed each other in a ring; its default is used");
    return {};
}

ColorInput ShaderInputs::constant_color(const std::string& name, const Constant& source, double multiplier,
                                        const ColorInput& fallback) const {
    const std::vector<double> values = numbers(source.value);
    if (values.size() != 1 && values.size() < 3) {
        warn("not a color " + shader_.path.GetString() + "." + name,
             "input '" + name + "' is not a colour; its default is used");
        return fallback;
    }
    const Color rgb = color_or(source.value, fallback.value);
    return scaled({to_rendering_space(translation_.warnings, shader_.path, source.color_space, rgb), -1}, multiplier);
}

void ShaderInputs::warn_of_node(const NodeOutput& source, const std::string& name) const {
    const std::string& type = source.node.type();
    translation_.warnings.warn("node " + type, source.node.path,
                               "node '" + type + "' is not supported; input '" + name + "' keeps its default");
}

TextureRead ShaderInputs::read(const NodeOutput& source, const TextureUse& use) {
    TextureRead texture = read_texture(translation_, source.node, use);
    if (std::find(st_names_.begin(), st_names_.end(), texture.st) == st_names_.end()) st_names_.push_back(texture.st);
    return texture;
}

}  // namespace etendue::hydra
