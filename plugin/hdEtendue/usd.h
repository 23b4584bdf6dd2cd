#pragma once

#include <pxr/pxr.h>

namespace etendue::hydra {

// USD's names carry prefixes of their own (Gf, Vt, Hd, ...) and none of ours does.
PXR_NAMESPACE_USING_DIRECTIVE

}  // namespace etendue::hydra
