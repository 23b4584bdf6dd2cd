#pragma once

#include <vector>

#include <etendue/requirements.h>

namespace etendue {

/// Whether surfaces of the material shine.
[[nodiscard]] bool is_emissive(const MaterialDesc& material);

/// By group: whether an instance places it.
[[nodiscard]] std::vector<bool> placed_groups(const SceneDescription& scene);

}  // namespace etendue
