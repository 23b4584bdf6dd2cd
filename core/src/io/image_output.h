#pragma once

#include <functional>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include <etendue/film_view.h>

namespace etendue {

/// Fills row y (0 on top) of the image in the specification's format, channels interleaved.
using FillRow = std::function<void(int y, void* row)>;

/// Writes the image atomically; the extension decides the format. Throws FileError naming the file and the reason.
void write_rows(const std::string& file, const OIIO::ImageSpec& spec, const FillRow& fill_row);

/// The AOV's data. Throws Error naming `file` when its size is not that of the image.
[[nodiscard]] const float* checked_data(const std::string& file, const RenderedImage& image, const AovImage& aov);
/// The same for any image of so many channels.
[[nodiscard]] const float* checked_data(const std::string& file, const RenderedImage& image, const std::string& name,
                                        int channels, const std::vector<float>& data);

}  // namespace etendue
