#pragma once

#include <array>
#include <string>

#include "material_network.h"
#include "translation.h"

namespace etendue::hydra {

/// The primvar that textures read when nothing else is said.
inline const char* const kDefaultSt = "st";

/// UsdUVTexture, MaterialX's image or tiledimage, by their USD or MaterialX names.
[[nodiscard]] bool is_texture(const NodeRef& node);

/// A texture of the scene, or (index < 0) the colour that stands in for a missing file.
struct TextureRead {
    int index = -1;
    std::array<double, 4> fallback{};
    std::string st = kDefaultSt;
};

/// How an input uses a texture.
struct TextureUse {
    bool data = false;  ///< not a colour: `auto` means raw
    double multiplier = 1;
    bool unpack_normal = false;  ///< map [0, 1] to [-1, 1]
};

/// Adds the texture of `node`, with its coordinates, to the scene.
[[nodiscard]] TextureRead read_texture(const Translation& translation, const NodeRef& node, const TextureUse& use);

}  // namespace etendue::hydra
