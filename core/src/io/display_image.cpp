#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <etendue/error.h>
#include <etendue/image_io.h>

#include "io/image_file.h"
#include "io/image_output.h"
#include "io/quantize.h"

namespace etendue {

namespace {

/// View transforms multiply by matrices and take powers: an infinity becomes NaN there, and would come out black where
/// it should be brightest. This is beyond the shoulder of any of them.
constexpr float kBrightest = 65504.0F;

float finite(float value) { return std::isnan(value) ? 0.0F : std::clamp(value, -kBrightest, kBrightest); }

std::vector<float> display_values(const std::string& file, const RenderedImage& image, const ColorConfig& config,
                                  const std::string& display, const std::string& view) {
    const AovImage* color = image.find(Aov::Color);
    if (!color) throw SettingsError("cannot write '" + file + "': the image has no color AOV");
    const float* data = checked_data(file, image, *color);
    std::vector<float> rgb(color->data.size());
    std::transform(data, data + rgb.size(), rgb.begin(), finite);
    config.apply(rgb, display, view);
    return rgb;
}

OIIO::ImageSpec describe(const std::string& file, const RenderedImage& image, bool srgb, int bits) {
    OIIO::ImageSpec spec(image.width, image.height, 3, bits == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16);
    if (srgb) spec.attribute("oiio:ColorSpace", "sRGB");
    const std::string extension = image_extension(file);
    if (extension == ".jpg" || extension == ".jpeg") {
        spec.attribute("Compression", "jpeg:95");
        spec.attribute("jpeg:subsampling", "4:4:4");  // halving the chroma smears small coloured highlights
    }
    return spec;
}

void check_request(const std::string& file, int bits) {
    if (image_file_kind(file) != ImageFileKind::Display) {
        throw SettingsError("cannot write display values to '" + file + "'; .exr is for scene-linear images");
    }
    if (bits != 8 && bits != 16) {
        throw SettingsError("cannot write '" + file + "' with " + std::to_string(bits) + " bits; 8 or 16 are possible");
    }
    const std::string extension = image_extension(file);
    if (bits == 16 && (extension == ".jpg" || extension == ".jpeg")) {
        throw SettingsError("cannot write '" + file + "' with 16 bits; jpeg has 8");
    }
}

template <typename T>
void write_quantized(const std::string& file, const OIIO::ImageSpec& spec, const std::vector<float>& rgb) {
    const std::size_t row_values = static_cast<std::size_t>(spec.width) * 3;
    write_rows(file, spec, [&](int y, void* row) {
        const float* values = rgb.data() + row_values * static_cast<std::size_t>(y);
        std::transform(values, values + row_values, static_cast<T*>(row), quantize<T>);
    });
}

}  // namespace

void write_display_image(const std::string& file, const RenderedImage& image, const ColorConfig& config,
                         const std::string& display, const std::string& view, int bits) {
    check_request(file, bits);
    const std::vector<float> rgb = display_values(file, image, config, display, view);
    const OIIO::ImageSpec spec = describe(file, image, config.encodes_srgb(display, view), bits);
    if (bits == 8) {
        write_quantized<std::uint8_t>(file, spec, rgb);
    } else {
        write_quantized<std::uint16_t>(file, spec, rgb);
    }
}

}  // namespace etendue
