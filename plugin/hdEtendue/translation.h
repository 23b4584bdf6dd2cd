#pragma once

#include <etendue/scene_description.h>

#include "usd.h"
#include "warnings.h"

namespace etendue::hydra {

/// What every part of a translation shares.
struct Translation {
    SceneDescription& scene;
    Warnings& warnings;
};

}  // namespace etendue::hydra
