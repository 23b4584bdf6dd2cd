#pragma once

#include <string_view>

namespace etendue {

/// The text of etendue.ocio, as it was when the library was built.
[[nodiscard]] std::string_view builtin_ocio_config();

}  // namespace etendue
