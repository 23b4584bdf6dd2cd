#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <etendue/film_view.h>

namespace etendue {

/// An image whose every value differs from every other: AOV, pixel and channel can be told from it.
inline RenderedImage numbered_image(int width, int height, const std::vector<Aov>& aovs) {
    RenderedImage image;
    image.width = image.full_width = width;
    image.height = image.full_height = height;
    image.window = {0, 0, width, height};
    for (const Aov aov : aovs) {
        AovImage layer{aov, aov_channels(aov), {}};
        const int count = width * height * layer.channels;
        for (int i = 0; i < count; ++i) layer.data.push_back(1000.0F * static_cast<float>(aov) + static_cast<float>(i));
        image.aovs.push_back(layer);
    }
    return image;
}

/// One row of colours.
inline RenderedImage row_of_colors(const std::vector<float>& rgb) {
    RenderedImage image = numbered_image(static_cast<int>(rgb.size() / 3), 1, {Aov::Color});
    image.aovs[0].data = rgb;
    return image;
}

template <typename T>
struct ReadImage {
    OIIO::ImageSpec spec;
    std::vector<T> values;
};

/// The file as it is, converted to T.
template <typename T>
ReadImage<T> read_image(const std::string& file, OIIO::TypeDesc type) {
    ReadImage<T> result;
    const auto input = OIIO::ImageInput::open(file);
    EXPECT_TRUE(input) << OIIO::geterror();
    if (!input) return result;
    result.spec = input->spec();
    result.values.resize(result.spec.image_pixels() * static_cast<std::size_t>(result.spec.nchannels));
    EXPECT_TRUE(input->read_image(0, 0, 0, -1, type, result.values.data())) << input->geterror();
    return result;
}

}  // namespace etendue
