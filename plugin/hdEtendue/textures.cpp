#include "textures.h"

#include <map>
#include <utility>
#include <vector>

#include "color_spaces.h"
#include "convert.h"
#include "texture_coordinates.h"
#include "texture_files.h"

namespace etendue::hydra {
namespace {

using Rgba = std::array<double, 4>;

bool is_usd_texture(const std::string& type) { return type == "UsdUVTexture" || type.starts_with("ND_UsdUVTexture"); }

bool is_image(const std::string& type) { return type.starts_with("ND_image_") || type.starts_with("ND_tiledimage_"); }

/// As many components as are authored over the defaults.
Rgba rgba_or(const VtValue& value, const Rgba& fallback) {
    Rgba out = fallback;
    const std::vector<double> all = numbers(value);
    for (std::size_t i = 0; i < std::min<std::size_t>(all.size(), 4); ++i) out[i] = all[i];
    return out;
}

TextureWrap wrap(Warnings& warnings, const NodeRef& node, const std::string& input, const std::string& unset) {
    static const std::map<std::string, TextureWrap> wraps{
        {"useMetadata", TextureWrap::UseMetadata}, {"black", TextureWrap::Black},   {"clamp", TextureWrap::Clamp},
        {"repeat", TextureWrap::Repeat},           {"mirror", TextureWrap::Mirror}, {"constant", TextureWrap::Black},
        {"periodic", TextureWrap::Repeat}};
    const std::string authored = text(constant_input(warnings, node, input));
    if (authored.empty()) return wraps.at(unset);
    const auto found = wraps.find(authored);
    if (found != wraps.end()) return found->second;
    warnings.warn("wrap " + authored, node.path, "unknown " + input + " '" + authored + "'; '" + unset + "' is used");
    return wraps.at(unset);
}

TextureColorSpace asset_color_space(Warnings& warnings, const NodeRef& node) {
    const InputSource source = resolve_input(node, "file");
    const auto* constant = std::get_if<Constant>(&source);
    return constant == nullptr ? TextureColorSpace::Auto : file_color_space(warnings, node.path, constant->color_space);
}

void fill_usd_texture(Warnings& warnings, const NodeRef& node, TextureDesc& desc) {
    const char* const unset = node.type().starts_with("ND_") ? "periodic" : "useMetadata";
    desc.wrap_s = wrap(warnings, node, "wrapS", unset);
    desc.wrap_t = wrap(warnings, node, "wrapT", unset);
    desc.scale = rgba_or(constant_input(warnings, node, "scale"), desc.scale);
    desc.bias = rgba_or(constant_input(warnings, node, "bias"), desc.bias);
    desc.fallback = rgba_or(constant_input(warnings, node, "fallback"), desc.fallback);
    const std::string token = text(constant_input(warnings, node, "sourceColorSpace"));
    if (token.empty()) {
        desc.color_space = asset_color_space(warnings, node);
    } else if (token == "raw") {
        desc.color_space = TextureColorSpace::Raw;
    } else if (token == "sRGB") {
        desc.color_space = TextureColorSpace::Srgb;
    } else if (token != "auto") {
        warnings.warn("sourceColorSpace " + token, node.path,
                      "unknown sourceColorSpace '" + token + "'; 'auto' is used");
    }
}

void fill_image(Warnings& warnings, const NodeRef& node, TextureDesc& desc) {
    desc.wrap_s = wrap(warnings, node, "uaddressmode", "periodic");
    desc.wrap_t = wrap(warnings, node, "vaddressmode", "periodic");
    const VtValue fallback = constant_input(warnings, node, "default");
    if (numbers(fallback).size() == 1) {
        const Color grey = color_or(fallback, {});
        desc.fallback = {grey[0], grey[1], grey[2], 1};
    } else {
        desc.fallback = rgba_or(fallback, desc.fallback);
    }
    const bool is_color = node.type().find("_color") != std::string::npos;
    desc.color_space = is_color ? asset_color_space(warnings, node) : TextureColorSpace::Raw;
}

void apply_use(const TextureUse& use, TextureDesc& desc) {
    if (use.data && desc.color_space == TextureColorSpace::Auto) desc.color_space = TextureColorSpace::Raw;
    for (std::size_t i = 0; i < 4; ++i) {
        if (use.unpack_normal) {
            desc.scale[i] *= 2;
            desc.bias[i] = 2 * desc.bias[i] - 1;
        }
        if (i == 3) continue;  // what is multiplied is the colour
        desc.scale[i] *= use.multiplier;
        desc.bias[i] *= use.multiplier;
        desc.fallback[i] *= use.multiplier;
    }
}

}  // namespace

bool is_texture(const NodeRef& node) { return is_usd_texture(node.type()) || is_image(node.type()); }

TextureRead read_texture(const Translation& translation, const NodeRef& node, const TextureUse& use) {
    Warnings& warnings = translation.warnings;
    TextureDesc desc;
    desc.name = node.path.GetString();
    const bool is_usd = is_usd_texture(node.type());
    if (is_usd) {
        fill_usd_texture(warnings, node, desc);
    } else {
        fill_image(warnings, node, desc);
    }
    apply_use(use, desc);
    const CoordinateSource st = texture_coordinates(warnings, node, is_usd ? "st" : "texcoord");
    desc.st_transform = st.transform;
    const auto file =
        texture_file(warnings, node.path, constant_input(warnings, node, "file"), "the texture's fallback colour");
    TextureRead read{-1, desc.fallback, st.primvar};
    if (!file) return read;
    desc.file = *file;
    read.index = static_cast<int>(translation.scene.textures.size());
    translation.scene.textures.push_back(std::move(desc));
    return read;
}

}  // namespace etendue::hydra
