#pragma once

#include <cstddef>

#include <etendue/scene_description.h>

namespace etendue {

/// Throws SceneError naming the material when it refers to a texture, or a channel of one, that does not exist.
void check_textures(const MaterialDesc& material, std::size_t texture_count);

}  // namespace etendue
