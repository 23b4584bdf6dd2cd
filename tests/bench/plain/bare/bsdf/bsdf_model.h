#pragma once

#include <variant>

#include "bsdf/diffuse.h"

namespace etendue {

using BsdfModel = std::variant<Diffuse>;

}  // namespace etendue
