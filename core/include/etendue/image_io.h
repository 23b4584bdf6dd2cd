#pragma once

#include <map>
#include <string>

#include <etendue/display.h>
#include <etendue/export.h>
#include <etendue/film_view.h>

namespace etendue {

using ImageMetadata = std::map<std::string, std::string>;

/// What the file name's extension asks for.
enum class ImageFileKind { SceneLinear, Display };

/// SceneLinear for .exr; Display for .png, .tif, .tiff, .jpg, .jpeg. Throws SettingsError naming the file otherwise.
[[nodiscard]] ETENDUE_EXPORT ImageFileKind image_file_kind(const std::string& file);

/// Throws FileError now rather than after the render when `file` cannot be created. Leaves nothing behind.
ETENDUE_EXPORT void check_writable(const std::string& file);

/// All AOVs as one float EXR, scene-linear Rec.709: R G B A for color (premultiplied) and alpha, then depth.Z,
/// normal.X/Y/Z, albedo.R/G/B, variance.R/G/B, sample_count, and strategies' images as
/// st.weighted.s2t3.R/G/B, as far as the image has them. A crop is the data window in the full image's display window.
/// `metadata` goes to the header. Written to a temporary file first, so a failure loses nothing. Throws SettingsError
/// when the name does not end in .exr or there is no AOV, FileError when writing fails.
ETENDUE_EXPORT void write_exr(const std::string& file, const RenderedImage& image, const ImageMetadata& metadata);

/// Color through the display and view, clamped and rounded to the nearest code; NaN is 0. `bits` is 8 or 16; jpeg takes
/// 8 only. A crop becomes a picture of the window alone. Opaque: light seen directly (a dome) has color where alpha is
/// 0, and the formats' unassociated alpha would make that invisible; whoever composites takes the EXR. Tagged sRGB when
/// the display is. Atomic like write_exr. Throws SettingsError (extension, bits, display, view, no color AOV) and
/// FileError.
ETENDUE_EXPORT void write_display_image(const std::string& file, const RenderedImage& image, const ColorConfig& config,
                                        const std::string& display = {}, const std::string& view = {}, int bits = 8);

}  // namespace etendue
