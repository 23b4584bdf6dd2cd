#pragma once

#include <etendue/scene_description.h>

#include "shader_inputs.h"

namespace etendue::hydra {

/// Surface shaders to materials, each in a file of its own. What an input means is core's to say; here it only finds
/// its place. A layer or mode that is not supported is warned about.
[[nodiscard]] MaterialDesc read_preview_surface(ShaderInputs& inputs);
[[nodiscard]] MaterialDesc read_open_pbr(ShaderInputs& inputs);
[[nodiscard]] MaterialDesc read_phong(ShaderInputs& inputs);

}  // namespace etendue::hydra
