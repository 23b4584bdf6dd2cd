#pragma once

#include <etendue/requirements.h>

namespace etendue {

/// What make_bsdf may make of the material, somewhere.
[[nodiscard]] LobeSet possible_lobes(const MaterialDesc& material);

}  // namespace etendue
