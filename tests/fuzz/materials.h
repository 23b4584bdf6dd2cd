#pragma once

#include <etendue/scene_description.h>

#include "fuzz/dice.h"

namespace etendue::test {

/// Any model with any parameters. `textures` of the scene may be used; `scale` is that of the scene's lengths.
[[nodiscard]] MaterialDesc random_material(Dice& dice, int textures, double scale);
[[nodiscard]] Color random_color(Dice& dice);

}  // namespace etendue::test
