#include <algorithm>
#include <array>
#include <cstddef>

#include <etendue/error.h>
#include <etendue/image_io.h>

#include "io/image_output.h"

namespace etendue {

namespace {

/// One AOV on its way into the file: its channels stand together in every pixel.
struct Layer {
    const float* data;
    std::size_t channels;
};

std::vector<std::string> color_channels(const std::string& name) { return {name + ".R", name + ".G", name + ".B"}; }

/// Suffixes of the AOV's channels: colours in R G B, directions in X Y Z, a depth in Z, what is neither without.
std::vector<std::string> channel_names(Aov aov) {
    const std::string name(aov_name(aov));
    switch (aov) {
        case Aov::Color:
            return {"R", "G", "B"};
        case Aov::Alpha:
            return {"A"};
        case Aov::Depth:
            return {name + ".Z"};
        case Aov::Normal:
            return {name + ".X", name + ".Y", name + ".Z"};
        case Aov::Albedo:
        case Aov::Variance:
            return color_channels(name);
        case Aov::SampleCount:
            break;
    }
    return {name};
}

/// The order in the file, whatever the order of the request.
constexpr std::array kFileOrder{Aov::Color,  Aov::Alpha,    Aov::Depth,      Aov::Normal,
                                Aov::Albedo, Aov::Variance, Aov::SampleCount};

OIIO::ImageSpec describe(const RenderedImage& image, const ImageMetadata& metadata) {
    OIIO::ImageSpec spec(image.width, image.height, 0, OIIO::TypeDesc::FLOAT);
    spec.channelnames.clear();
    spec.x = image.window.x0;
    spec.y = image.window.y0;
    spec.full_x = 0;
    spec.full_y = 0;
    spec.full_width = image.full_width;
    spec.full_height = image.full_height;
    for (const auto& [key, value] : metadata) spec.attribute(key, value);
    // Rec.709 and D65 are also what a file without them means; said outright, nobody needs to know that.
    constexpr std::array<float, 8> chromaticities{0.64F, 0.33F, 0.30F, 0.60F, 0.15F, 0.06F, 0.3127F, 0.3290F};
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), chromaticities.data());
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("compression", "zip");
    return spec;
}

void add_channels(OIIO::ImageSpec& spec, const std::vector<std::string>& names) {
    spec.channelnames.insert(spec.channelnames.end(), names.begin(), names.end());
    spec.nchannels += static_cast<int>(names.size());
}

void interleave(const std::vector<Layer>& layers, std::size_t first_pixel, std::size_t count, float* row) {
    for (std::size_t pixel = first_pixel; pixel < first_pixel + count; ++pixel) {
        for (const Layer& layer : layers) {
            row = std::copy_n(layer.data + pixel * layer.channels, layer.channels, row);
        }
    }
}

}  // namespace

void write_exr(const std::string& file, const RenderedImage& image, const ImageMetadata& metadata) {
    if (image_file_kind(file) != ImageFileKind::SceneLinear) {
        throw SettingsError("cannot write scene-linear AOVs to '" + file + "'; the name should end in .exr");
    }
    OIIO::ImageSpec spec = describe(image, metadata);
    std::vector<Layer> layers;
    for (const Aov aov : kFileOrder) {
        const AovImage* found = image.find(aov);
        if (!found) continue;
        layers.push_back({checked_data(file, image, *found), static_cast<std::size_t>(aov_channels(aov))});
        if (aov == Aov::Alpha) spec.alpha_channel = spec.nchannels;
        add_channels(spec, channel_names(aov));
    }
    for (const StrategyImage& strategy : image.strategy_images) {
        const std::string name = strategy_image_name(strategy);
        layers.push_back({checked_data(file, image, name, 3, strategy.data), 3});
        add_channels(spec, color_channels(name));
    }
    if (layers.empty()) throw SettingsError("cannot write '" + file + "': the image has no AOV");
    const auto width = static_cast<std::size_t>(image.width);
    write_rows(file, spec, [&](int y, void* row) {
        interleave(layers, width * static_cast<std::size_t>(y), width, static_cast<float*>(row));
    });
}

}  // namespace etendue
