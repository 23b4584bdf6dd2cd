#pragma once

#include <optional>
#include <string>

#include <pxr/base/vt/value.h>

#include "usd.h"
#include "warnings.h"

namespace etendue::hydra {

/// The plain file of an asset or file name (`<UDIM>` stays in it), copied out of its package (.usdz) if it is in one:
/// image readers open plain files. Empty, after a warning that names `stand_in`, when there is none.
[[nodiscard]] std::optional<std::string> texture_file(Warnings& warnings, const SdfPath& path, const VtValue& asset,
                                                      const std::string& stand_in);

}  // namespace etendue::hydra
