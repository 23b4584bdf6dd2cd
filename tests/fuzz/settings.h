#pragma once

#include <etendue/render_settings.h>

#include "fuzz/dice.h"

namespace etendue::test {

/// A small picture of a few passes, by any integrator.
[[nodiscard]] RenderSettings random_settings(Dice& dice);

}  // namespace etendue::test
