#pragma once

#include <etendue/scene_description.h>

#include "fuzz/dice.h"

namespace etendue::test {

/// Any kind but mesh lights, about the studio. `texture_file` may be shone through.
[[nodiscard]] LightDesc random_light(Dice& dice, const std::string& texture_file);
/// Makes a mesh light of a shape.
[[nodiscard]] LightDesc random_mesh_light(Dice& dice, int shape);

}  // namespace etendue::test
