#pragma once

#include <etendue/scene_description.h>

#include "fuzz/dice.h"

namespace etendue::test {

/// Mostly looks at the origin from 4 units off; else from anywhere among the shapes. `scale`: of the world's lengths,
/// in which lens and aperture are measured.
[[nodiscard]] CameraDesc random_camera(Dice& dice, double scale);

}  // namespace etendue::test
