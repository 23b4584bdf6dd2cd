#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <etendue/error.h>
#include <etendue/image_io.h>

#include "core/io/temporary_directory.h"
#include "core/io/test_image.h"

namespace etendue {
namespace {

const std::vector<Aov> kAllAovs{Aov::SampleCount, Aov::Variance, Aov::Albedo, Aov::Normal,
                                Aov::Depth,       Aov::Alpha,    Aov::Color};

ReadImage<float> read_floats(const std::string& file) { return read_image<float>(file, OIIO::TypeDesc::FLOAT); }

std::size_t channel_index(const OIIO::ImageSpec& spec, const std::string& name) {
    const int index = spec.channelindex(name);
    EXPECT_GE(index, 0) << name;
    return static_cast<std::size_t>(std::max(index, 0));
}

void expect_channel(const ReadImage<float>& read, const std::string& name, const AovImage& aov, std::size_t offset) {
    const std::size_t index = channel_index(read.spec, name);
    const auto stride = static_cast<std::size_t>(read.spec.nchannels);
    const auto channels = static_cast<std::size_t>(aov.channels);
    for (std::size_t pixel = 0; pixel < read.spec.image_pixels(); ++pixel) {
        EXPECT_EQ(read.values[pixel * stride + index], aov.data[pixel * channels + offset]) << name << " " << pixel;
    }
}

TEST(Exr, AllAovsComeBackUnderTheirNames) {
    const TemporaryDirectory directory;
    const RenderedImage image = numbered_image(5, 67, kAllAovs);  // more rows than are written at once
    write_exr(directory.file("all.exr"), image, {});
    EXPECT_EQ(directory.count(), 1);

    const ReadImage<float> read = read_floats(directory.file("all.exr"));
    EXPECT_EQ(read.spec.width, 5);
    EXPECT_EQ(read.spec.height, 67);
    EXPECT_EQ(read.spec.nchannels, 15);
    EXPECT_EQ(read.spec.format, OIIO::TypeDesc::FLOAT);
    EXPECT_TRUE(read.spec.channelformats.empty());
    const std::pair<Aov, std::vector<std::string>> names[] = {
        {Aov::Color, {"R", "G", "B"}},
        {Aov::Alpha, {"A"}},
        {Aov::Depth, {"depth.Z"}},
        {Aov::Normal, {"normal.X", "normal.Y", "normal.Z"}},
        {Aov::Albedo, {"albedo.R", "albedo.G", "albedo.B"}},
        {Aov::Variance, {"variance.R", "variance.G", "variance.B"}},
        {Aov::SampleCount, {"sample_count"}},
    };
    for (const auto& [aov, channels] : names) {
        for (std::size_t c = 0; c < channels.size(); ++c) expect_channel(read, channels[c], *image.find(aov), c);
    }
}

TEST(Exr, StrategiesAreLayers) {
    const TemporaryDirectory directory;
    RenderedImage image = numbered_image(2, 3, {Aov::Color});
    for (const bool weighted : {true, false}) {
        const std::vector<float> data = numbered_image(2, 3, {weighted ? Aov::Albedo : Aov::Variance}).aovs[0].data;
        image.strategy_images.push_back({{2, 13}, weighted, data});
    }
    write_exr(directory.file("x.exr"), image, {});
    const ReadImage<float> read = read_floats(directory.file("x.exr"));
    EXPECT_EQ(read.spec.nchannels, 9);
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string name = i == 0 ? "st.weighted.s2t13" : "st.unweighted.s2t13";
        const AovImage aov{Aov::Albedo, 3, image.strategy_images[i].data};
        expect_channel(read, name + ".R", aov, 0);
        expect_channel(read, name + ".G", aov, 1);
        expect_channel(read, name + ".B", aov, 2);
    }
    image.strategy_images[1].data.pop_back();
    EXPECT_THROW(write_exr(directory.file("y.exr"), image, {}), Error);
}

TEST(Exr, TheOrderOfTheRequestDoesNotMatter) {
    const TemporaryDirectory directory;
    std::vector<Aov> reversed(kAllAovs.rbegin(), kAllAovs.rend());
    write_exr(directory.file("a.exr"), numbered_image(2, 2, kAllAovs), {});
    write_exr(directory.file("b.exr"), numbered_image(2, 2, reversed), {});
    const ReadImage<float> a = read_floats(directory.file("a.exr"));
    const ReadImage<float> b = read_floats(directory.file("b.exr"));
    EXPECT_EQ(a.spec.channelnames, b.spec.channelnames);
    EXPECT_EQ(a.values, b.values);
}

TEST(Exr, ColorAndAlphaAreRgba) {
    const TemporaryDirectory directory;
    write_exr(directory.file("x.exr"), numbered_image(2, 2, {Aov::Color, Aov::Alpha}), {});
    const ReadImage<float> read = read_floats(directory.file("x.exr"));
    EXPECT_EQ(read.spec.channelnames, (std::vector<std::string>{"R", "G", "B", "A"}));
    EXPECT_EQ(read.spec.alpha_channel, 3);
}

TEST(Exr, ACropIsAWindowInTheFullImage) {
    const TemporaryDirectory directory;
    RenderedImage image = numbered_image(3, 2, {Aov::Color});
    image.window = {10, 20, 13, 22};
    image.full_width = 64;
    image.full_height = 48;
    write_exr(directory.file("crop.exr"), image, {});
    const ReadImage<float> read = read_floats(directory.file("crop.exr"));
    EXPECT_EQ(read.spec.x, 10);
    EXPECT_EQ(read.spec.y, 20);
    EXPECT_EQ(read.spec.width, 3);
    EXPECT_EQ(read.spec.height, 2);
    EXPECT_EQ(read.spec.full_x, 0);
    EXPECT_EQ(read.spec.full_y, 0);
    EXPECT_EQ(read.spec.full_width, 64);
    EXPECT_EQ(read.spec.full_height, 48);
    EXPECT_EQ(read.values, image.aovs[0].data);
}

TEST(Exr, OverscanMayBeginBelowZero) {
    const TemporaryDirectory directory;
    RenderedImage image = numbered_image(3, 2, {Aov::Color});
    image.window = {-1, -1, 2, 1};
    image.full_width = 1;
    image.full_height = 1;
    write_exr(directory.file("overscan.exr"), image, {});
    const ReadImage<float> read = read_floats(directory.file("overscan.exr"));
    EXPECT_EQ(read.spec.x, -1);
    EXPECT_EQ(read.spec.y, -1);
    EXPECT_EQ(read.values, image.aovs[0].data);
}

TEST(Exr, MetadataAndColorimetryAreInTheHeader) {
    const TemporaryDirectory directory;
    const ImageMetadata metadata{
        {"etendue:integrator", "bdpt"}, {"Software", "Etendue"}, {"seed", "18446744073709551615"}};
    write_exr(directory.file("x.exr"), numbered_image(2, 2, {Aov::Color}), metadata);
    const OIIO::ImageSpec spec = read_floats(directory.file("x.exr")).spec;
    for (const auto& [key, value] : metadata) EXPECT_EQ(spec.get_string_attribute(key), value) << key;
    float chromaticities[8] = {};
    ASSERT_TRUE(spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), chromaticities));
    EXPECT_EQ(chromaticities[0], 0.64F);
    EXPECT_EQ(chromaticities[7], 0.3290F);
}

TEST(Exr, InfinitiesAndHugeValuesSurvive) {
    const TemporaryDirectory directory;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    RenderedImage image = numbered_image(2, 1, {Aov::Color, Aov::Depth, Aov::Variance});
    image.aovs[0].data = {1e30F, -1e-30F, 0.1F, 70000.0F, 1.0F / 3, 0};
    image.aovs[1].data = {infinity, 2};
    image.aovs[2].data.assign(6, infinity);
    write_exr(directory.file("x.exr"), image, {});
    const ReadImage<float> read = read_floats(directory.file("x.exr"));
    expect_channel(read, "R", image.aovs[0], 0);
    expect_channel(read, "G", image.aovs[0], 1);
    expect_channel(read, "B", image.aovs[0], 2);
    expect_channel(read, "depth.Z", image.aovs[1], 0);
    expect_channel(read, "variance.G", image.aovs[2], 1);
}

TEST(Exr, WhatCannotBeWrittenIsRefused) {
    const TemporaryDirectory directory;
    const RenderedImage image = numbered_image(2, 2, {Aov::Color});
    EXPECT_THROW(write_exr(directory.file("x.png"), image, {}), SettingsError);
    EXPECT_THROW(write_exr(directory.file("x.exr"), numbered_image(2, 2, {}), {}), SettingsError);
    RenderedImage short_of_data = image;
    short_of_data.aovs[0].data.pop_back();
    EXPECT_THROW(write_exr(directory.file("x.exr"), short_of_data, {}), Error);
    RenderedImage wrong_channels = image;
    wrong_channels.aovs[0].channels = 4;
    EXPECT_THROW(write_exr(directory.file("x.exr"), wrong_channels, {}), Error);
    EXPECT_EQ(directory.count(), 0);
}

}  // namespace
}  // namespace etendue
