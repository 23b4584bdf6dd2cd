#pragma once

#include <etendue/scene_description.h>

#include "fuzz/dice.h"

namespace etendue::test {

/// Any kind of shape, about as large as 1.
[[nodiscard]] GeometryDesc random_geometry(Dice& dice);

}  // namespace etendue::test
