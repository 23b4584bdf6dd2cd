#pragma once

#include <cstddef>

#include <etendue/scene_description.h>

namespace etendue {

/// Throws SceneError naming the material when it refers to a texture, or a channel of one, that does not exist, or when
/// an index of refraction or a depth is negative or not a number. What textures can vary is brought into its range
/// instead (InputReader).
void check_material(const MaterialDesc& material, std::size_t texture_count);

}  // namespace etendue
