#pragma once

#include <string>

namespace etendue {

/// The extension with its dot, in lower case; empty when there is none.
[[nodiscard]] std::string image_extension(const std::string& file);

}  // namespace etendue
