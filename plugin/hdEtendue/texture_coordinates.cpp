#include "texture_coordinates.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "convert.h"
#include "textures.h"

namespace etendue::hydra {
namespace {

using Affine = std::array<double, 6>;

/// outer after inner.
Affine compose(const Affine& outer, const Affine& inner) {
    Affine out{};
    for (std::size_t row = 0; row < 2; ++row) {
        const double* const o = &outer[3 * row];
        for (std::size_t column = 0; column < 3; ++column) {
            out[3 * row + column] = o[0] * inner[column] + o[1] * inner[3 + column];
        }
        out[3 * row + 2] += o[2];
    }
    return out;
}

std::array<double, 2> pair_or(const VtValue& value, const std::array<double, 2>& fallback) {
    const std::vector<double> all = numbers(value);
    if (all.size() < 2) return fallback;
    return {all[0], all[1]};
}

/// UsdTransform2d: scale, then rotate counter-clockwise, then translate.
Affine transform_2d(Warnings& warnings, const NodeRef& node) {
    const double angle = number_or(constant_input(warnings, node, "rotation"), 0) * std::numbers::pi_v<double> / 180;
    const auto scale = pair_or(constant_input(warnings, node, "scale"), {1, 1});
    const auto translation = pair_or(constant_input(warnings, node, "translation"), {0, 0});
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * scale[0], -s * scale[1], translation[0], s * scale[0], c * scale[1], translation[1]};
}

std::string primvar_or_st(const VtValue& name) {
    const std::string authored = text(name);
    return authored.empty() ? kDefaultSt : authored;
}

/// `rest` is how many nodes there can be upstream: more are a ring.
CoordinateSource coordinates_of(Warnings& warnings, const NodeRef& node, const std::string& input, std::size_t rest) {
    if (rest == 0) {
        warnings.warn("ring of nodes " + node.path.GetString(), node.path,
                      "the nodes of its texture coordinates feed each other in a ring; primvar 'st' is used");
        return {kDefaultSt};
    }
    const InputSource source = resolve_input(node, input);
    if (const auto* constant = std::get_if<Constant>(&source)) {
        const auto place = pair_or(constant->value, {0, 0});
        return {kDefaultSt, {0, 0, place[0], 0, 0, place[1]}};
    }
    const auto* output = std::get_if<NodeOutput>(&source);
    if (output == nullptr) return {kDefaultSt, {1, 0, 0, 0, 1, 0}};
    const NodeRef& upstream = output->node;
    const std::string& type = upstream.type();
    if (type == "UsdPrimvarReader_float2" || type == "ND_UsdPrimvarReader_vector2") {
        return {primvar_or_st(constant_input(warnings, upstream, "varname"))};
    }
    if (type == "ND_geompropvalue_vector2") return {primvar_or_st(constant_input(warnings, upstream, "geomprop"))};
    if (type == "ND_texcoord_vector2") return {kDefaultSt};
    if (type == "UsdTransform2d" || type == "ND_UsdTransform2d") {
        const CoordinateSource inner = coordinates_of(warnings, upstream, "in", rest - 1);
        return {inner.primvar, compose(transform_2d(warnings, upstream), inner.transform)};
    }
    warnings.warn("texture coordinate node " + type, upstream.path,
                  "node '" + type + "' is not supported for texture coordinates; primvar 'st' is used");
    return {kDefaultSt};
}

}  // namespace

CoordinateSource texture_coordinates(Warnings& warnings, const NodeRef& node, const std::string& input) {
    CoordinateSource source = coordinates_of(warnings, node, input, node.network->nodes.size());
    if (node.type().starts_with("ND_tiledimage")) {
        const auto tiling = pair_or(constant_input(warnings, node, "uvtiling"), {1, 1});
        const auto offset = pair_or(constant_input(warnings, node, "uvoffset"), {0, 0});
        source.transform = compose({tiling[0], 0, -offset[0], 0, tiling[1], -offset[1]}, source.transform);
    }
    return source;
}

}  // namespace etendue::hydra
