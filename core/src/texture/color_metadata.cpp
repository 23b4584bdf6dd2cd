#include "texture/color_metadata.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace etendue {

namespace {

enum class Declared { Nothing, Srgb, Linear };

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

/// Whether a PNG holds the chunk. OpenImageIO calls a PNG without any colour chunk sRGB too, so its word is not enough.
bool png_has_chunk(const std::string& file, std::string_view wanted) {
    constexpr int signature_bytes = 8;
    constexpr int crc_bytes = 4;
    std::ifstream stream(file, std::ios::binary);
    stream.seekg(signature_bytes);
    std::array<char, 8> header{};  // length, big-endian, and type
    while (stream.read(header.data(), header.size())) {
        const std::string_view type(header.data() + 4, 4);
        if (type == wanted) return true;
        if (type == "IDAT") return false;  // colour chunks come before the pixels
        std::uint32_t length = 0;
        for (int i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(header[static_cast<unsigned>(i)]);
        stream.seekg(static_cast<std::streamoff>(length) + crc_bytes, std::ios::cur);
    }
    return false;
}

bool names_srgb(const std::string& space) {
    // Gamma 2.2 with these primaries is how sRGB was declared before there was a chunk for it.
    for (const char* name : {"srgb", "srgb_rec709_scene", "srgb_rec709_display", "srgb_texture", "gamma2.2",
                             "g22_rec709_scene", "g22_rec709_display"}) {
        if (space == name) return true;
    }
    return false;
}

bool names_linear(const std::string& space) {
    return space.starts_with("lin") || space == "scene_linear" || space == "raw" || space == "data";
}

/// The formats whose reader always names a space, whatever the file says.
bool is_guess(const std::string& file, const std::string& format, const OIIO::ImageSpec& spec,
              const std::string& space) {
    constexpr int exif_srgb = 1;
    if (format == "png") return space.starts_with("srgb") && !png_has_chunk(file, "sRGB");
    if (format == "jpeg") return spec.get_int_attribute("Exif:ColorSpace") != exif_srgb;
    return format == "dds" || format == "gif" || format == "heif" || format == "jpeg2000" || format == "webp";
}

Declared declared_color_space(const std::string& file, const std::string& format, const OIIO::ImageSpec& spec) {
    const std::string space = lower(std::string(spec.get_string_attribute("oiio:ColorSpace")));
    if (space.empty() || is_guess(file, format, spec, space)) return Declared::Nothing;
    if (names_srgb(space)) return Declared::Srgb;
    return names_linear(space) ? Declared::Linear : Declared::Nothing;
}

}  // namespace

bool auto_color_space_is_srgb(const std::string& file, const std::string& format, const OIIO::ImageSpec& spec) {
    switch (declared_color_space(file, format, spec)) {
        case Declared::Srgb:
            return true;
        case Declared::Linear:
            return false;
        case Declared::Nothing:
            break;
    }
    return spec.format == OIIO::TypeDesc::UINT8 && (spec.nchannels == 3 || spec.nchannels == 4);
}

}  // namespace etendue
