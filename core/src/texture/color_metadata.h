#pragma once

#include <string>

#include <OpenImageIO/imageio.h>

namespace etendue {

/// What sourceColorSpace "auto" means for a file: its own metadata decides; without any, 8 bits with three or four
/// channels are sRGB and all else is raw. `format` is OpenImageIO's name of the file format.
[[nodiscard]] bool auto_color_space_is_srgb(const std::string& file, const std::string& format,
                                            const OIIO::ImageSpec& spec);

}  // namespace etendue
