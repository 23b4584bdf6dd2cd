#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>

#include <gtest/gtest.h>

#include <etendue/error.h>
#include <etendue/image_io.h>

#include "core/io/temporary_directory.h"
#include "core/io/test_image.h"
#include "io/builtin_config.h"
#include "io/quantize.h"

namespace etendue {
namespace {

class DisplayImage : public testing::Test {
protected:
    DisplayImage() : config_(write_config()) {}

    std::string write_config() {
        const std::string file = directory_.file("etendue.ocio");
        std::ofstream(file) << builtin_ocio_config();
        return file;
    }

    template <typename T>
    std::vector<T> write_and_read(const std::string& name, const RenderedImage& image, const std::string& display,
                                  const std::string& view) {
        constexpr int bits = sizeof(T) * 8;
        write_display_image(directory_.file(name), image, config_, display, view, bits);
        const auto type = bits == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16;
        const ReadImage<T> read = read_image<T>(directory_.file(name), type);
        EXPECT_EQ(read.spec.format, type);
        EXPECT_EQ(read.spec.nchannels, 3);
        EXPECT_EQ(read.spec.width, image.width);
        EXPECT_EQ(read.spec.height, image.height);
        return read.values;
    }

    TemporaryDirectory directory_;
    ColorConfig config_;
};

TEST(Quantize, RoundsToTheNearestCode) {
    for (int code = 0; code < 256; ++code) {
        const float exact = static_cast<float>(code) / 255.0F;
        EXPECT_EQ(quantize<std::uint8_t>(exact), code);
        // half a code away, less or more than float can blur
        EXPECT_EQ(quantize<std::uint8_t>((static_cast<float>(code) + 0.4999F) / 255.0F), code);
        EXPECT_EQ(quantize<std::uint8_t>((static_cast<float>(code) - 0.4999F) / 255.0F), code);
    }
    for (int code = 0; code < 65536; ++code) {
        EXPECT_EQ(quantize<std::uint16_t>(static_cast<float>(code) / 65535.0F), code);
    }
}

TEST(Quantize, ClampsAndTakesNanForBlack) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(quantize<std::uint8_t>(-0.1F), 0);
    EXPECT_EQ(quantize<std::uint8_t>(-infinity), 0);
    EXPECT_EQ(quantize<std::uint8_t>(1.1F), 255);
    EXPECT_EQ(quantize<std::uint8_t>(infinity), 255);
    EXPECT_EQ(quantize<std::uint8_t>(std::nanf("")), 0);
    EXPECT_EQ(quantize<std::uint16_t>(infinity), 65535);
}

TEST_F(DisplayImage, PixelsStandWhereTheyStood) {
    RenderedImage image = numbered_image(7, 70, {Aov::Alpha, Aov::Color});  // more rows than are written at once
    std::vector<std::uint16_t> expected;
    for (std::size_t i = 0; i < image.aovs[1].data.size(); ++i) {
        expected.push_back(static_cast<std::uint16_t>(40 * i));
        image.aovs[1].data[i] = static_cast<float>(40 * i) / 65535.0F;
    }
    EXPECT_EQ(write_and_read<std::uint16_t>("x.png", image, "sRGB", "Raw"), expected);
    EXPECT_EQ(write_and_read<std::uint16_t>("x.tif", image, "sRGB", "Raw"), expected);
}

TEST_F(DisplayImage, SrgbCodes) {
    // 1.055 * v^(1/2.4) - 0.055 of 0.18, 0.5, 1 is 0.461356, 0.735357, 1
    const RenderedImage image = row_of_colors({0.18F, 0.5F, 1.0F, 0.0F, 2.0F, -1.0F});
    EXPECT_EQ(write_and_read<std::uint8_t>("x.png", image, "sRGB", "Un-tone-mapped"),
              (std::vector<std::uint8_t>{118, 188, 255, 0, 255, 0}));
    EXPECT_EQ(write_and_read<std::uint16_t>("x.tiff", image, "sRGB", "Un-tone-mapped"),
              (std::vector<std::uint16_t>{30235, 48192, 65535, 0, 65535, 0}));
}

TEST_F(DisplayImage, InfinityIsWhiteAndNanBlackInEveryView) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::nanf("");
    const RenderedImage image = row_of_colors({infinity, infinity, infinity, nan, nan, nan});
    for (const std::string& view : config_.views("sRGB")) {
        EXPECT_EQ(write_and_read<std::uint8_t>("x.png", image, "sRGB", view),
                  (std::vector<std::uint8_t>{255, 255, 255, 0, 0, 0}))
            << view;
    }
}

TEST_F(DisplayImage, TheDefaultViewIsTheConfigurations) {
    const RenderedImage image = row_of_colors({0.18F, 0.18F, 0.18F});
    EXPECT_EQ(write_and_read<std::uint8_t>("x.png", image, "", ""), (std::vector<std::uint8_t>{91, 91, 91}));
}

TEST_F(DisplayImage, OnlySrgbIsTaggedSrgb) {
    const RenderedImage image = row_of_colors({0.18F, 0.5F, 1.0F});
    const auto png_bytes = [&](const std::string& display) {
        write_display_image(directory_.file("x.png"), image, config_, display);
        std::ifstream stream(directory_.file("x.png"), std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(stream), {});
    };
    EXPECT_NE(png_bytes("sRGB").find("sRGB"), std::string::npos);
    EXPECT_EQ(png_bytes("Rec.1886").find("sRGB"), std::string::npos);
}

TEST_F(DisplayImage, JpegTakesEightBits) {
    RenderedImage image = numbered_image(16, 16, {Aov::Color});
    image.aovs[0].data.assign(image.aovs[0].data.size(), 0.5F);
    const std::vector<std::uint8_t> values = write_and_read<std::uint8_t>("x.JPG", image, "sRGB", "Un-tone-mapped");
    // A flat block has one coefficient, eight times the value; its step of 2 at this quality is a quarter of a code.
    // The way to YCbCr and back rounds again.
    for (const std::uint8_t value : values) EXPECT_NEAR(value, 188, 1);
    EXPECT_THROW(write_display_image(directory_.file("x.jpeg"), image, config_, "", "", 16), SettingsError);
}

TEST_F(DisplayImage, ACropIsAPictureOfItsWindow) {
    RenderedImage image = row_of_colors({1, 0, 0, 0, 1, 0});
    image.window = {10, 20, 12, 21};
    image.full_width = 64;
    image.full_height = 48;
    EXPECT_EQ(write_and_read<std::uint8_t>("x.png", image, "sRGB", "Raw"),
              (std::vector<std::uint8_t>{255, 0, 0, 0, 255, 0}));
}

TEST_F(DisplayImage, WhatCannotBeWrittenIsRefusedAndNothingIsLeft) {
    const RenderedImage image = row_of_colors({1, 0, 0});
    const auto before = directory_.count();
    EXPECT_THROW(write_display_image(directory_.file("x.exr"), image, config_), SettingsError);
    EXPECT_THROW(write_display_image(directory_.file("x.png"), image, config_, "CRT"), SettingsError);
    EXPECT_THROW(write_display_image(directory_.file("x.png"), image, config_, "", "CRT"), SettingsError);
    EXPECT_THROW(write_display_image(directory_.file("x.png"), image, config_, "", "", 12), SettingsError);
    EXPECT_THROW(write_display_image(directory_.file("x.png"), numbered_image(1, 1, {Aov::Depth}), config_),
                 SettingsError);
    EXPECT_THROW(write_display_image(directory_.file("no/x.png"), image, config_), FileError);
    EXPECT_EQ(directory_.count(), before);
}

}  // namespace
}  // namespace etendue
