#include <algorithm>
#include <cctype>
#include <filesystem>

#include <etendue/error.h>
#include <etendue/image_io.h>

#include "io/image_file.h"
#include "io/replaced_file.h"

namespace etendue {

std::string image_extension(const std::string& file) {
    std::string extension = std::filesystem::path(file).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

ImageFileKind image_file_kind(const std::string& file) {
    const std::string extension = image_extension(file);
    if (extension == ".exr") return ImageFileKind::SceneLinear;
    for (const char* display : {".png", ".tif", ".tiff", ".jpg", ".jpeg"}) {
        if (extension == display) return ImageFileKind::Display;
    }
    throw SettingsError("cannot tell what to write to '" + file +
                        "'; the name should end in .exr (scene-linear) or in .png, .tif, .tiff, .jpg, .jpeg (display)");
}

void check_writable(const std::string& file) { const ReplacedFile removed_at_once(file); }

}  // namespace etendue
