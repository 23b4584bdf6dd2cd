#include "texture/texture_set.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <etendue/error.h>

#include "core/io/temporary_directory.h"
#include "texture/texture_cache.h"

namespace etendue {
namespace {

using Value = TextureSet::Value;

// Bilinear weights and sums are a few double operations on numbers of size one.
constexpr double kTolerance = 1e-14;

double srgb_decode(double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }

class TextureTest : public testing::Test {
protected:
    /// Writes pixels as they are given, rows from the top; no conversion happens when `type` is T's.
    template <typename T>
    std::string write(const std::string& name, int width, int height, int channels, const std::vector<T>& values,
                      OIIO::TypeDesc type, const std::vector<std::pair<std::string, std::string>>& attributes = {}) {
        OIIO::ImageSpec spec(width, height, channels, type);
        for (const auto& [key, value] : attributes) spec.attribute(key, value);
        return write_spec(name, spec, values, type);
    }

    template <typename T>
    std::string write_spec(const std::string& name, OIIO::ImageSpec spec, const std::vector<T>& values,
                           OIIO::TypeDesc type) {
        spec.attribute("oiio:UnassociatedAlpha", 1);  // store rgb as given
        const std::string file = directory_.file(name);
        const auto output = OIIO::ImageOutput::create(file);
        EXPECT_TRUE(output && output->open(file, spec)) << name;
        EXPECT_TRUE(output->write_image(type, values.data())) << output->geterror();
        EXPECT_TRUE(output->close());
        return file;
    }

    std::string write_bytes(const std::string& name, int width, int height, int channels,
                            const std::vector<std::uint8_t>& values,
                            const std::vector<std::pair<std::string, std::string>>& attributes = {}) {
        return write(name, width, height, channels, values, OIIO::TypeDesc::UINT8, attributes);
    }

    std::string write_floats(const std::string& name, int width, int height, int channels,
                             const std::vector<float>& values,
                             const std::vector<std::pair<std::string, std::string>>& attributes = {}) {
        return write(name, width, height, channels, values, OIIO::TypeDesc::FLOAT, attributes);
    }

    /// red green
    /// blue white
    std::string four_colors() {
        return write_bytes("four.png", 2, 2, 3, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255});
    }

    static TextureDesc describe(const std::string& file, TextureColorSpace space = TextureColorSpace::Raw,
                                TextureWrap wrap = TextureWrap::Clamp) {
        TextureDesc desc;
        desc.name = "/Looks/Texture";
        desc.file = file;
        desc.color_space = space;
        desc.wrap_s = desc.wrap_t = wrap;
        return desc;
    }

    static TextureSet open(const TextureDesc& desc) { return TextureSet(std::vector{desc}); }

    static std::string refusal(const TextureDesc& desc) {
        try {
            (void)open(desc);
        } catch (const FileError& error) {
            return error.what();
        }
        return "accepted";
    }

    static void expect_value(const Value& actual, const Value& expected, double tolerance = kTolerance) {
        for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance) << "channel " << c;
    }

    TemporaryDirectory directory_;
};

// --------------------------------------------------------------------------------------------- where texels are

TEST_F(TextureTest, StBeginsAtTheLowerLeft) {
    const TextureSet textures = open(describe(four_colors()));
    expect_value(textures.lookup(0, 0.25, 0.25), {0, 0, 1, 1});
    expect_value(textures.lookup(0, 0.75, 0.25), {1, 1, 1, 1});
    expect_value(textures.lookup(0, 0.25, 0.75), {1, 0, 0, 1});
    expect_value(textures.lookup(0, 0.75, 0.75), {0, 1, 0, 1});
}

TEST_F(TextureTest, TexelsBeginAtTheUpperLeft) {
    TextureDesc desc = describe(four_colors());
    desc.scale = {2, 1, 1, 1};
    desc.st_transform = {0, 0, 0, 0, 0, 0};  // has no say
    const TextureSet textures = open(desc);
    expect_value(textures.texel(0, 0, 1), {0, 0, 1, 1});
    expect_value(textures.texel(0, 1, 1), {2, 1, 1, 1});
    expect_value(textures.texel(0, 0, 0), {2, 0, 0, 1});
    expect_value(textures.texel(0, 1, 0), {0, 1, 0, 1});
}

TEST_F(TextureTest, IsBilinearBetweenTexelCentres) {
    const TextureSet textures = open(describe(four_colors()));
    expect_value(textures.lookup(0, 0.5, 0.5), {0.5, 0.5, 0.5, 1});
    // three eighths of the way from left to right, one quarter from bottom to top
    const double x = (0.4375 - 0.25) / 0.5;
    const double y = (0.375 - 0.25) / 0.5;
    expect_value(textures.lookup(0, 0.4375, 0.375), {x * (1 - y) + (1 - x) * y, x, 1 - y, 1});
}

TEST_F(TextureTest, LookupChannelIsAChannelOfLookup) {
    const TextureSet textures = open(describe(four_colors()));
    const Value value = textures.lookup(0, 0.4375, 0.375);
    for (int c = 0; c < 4; ++c) {
        EXPECT_EQ(textures.lookup_channel(0, 0.4375, 0.375, c), value[static_cast<std::size_t>(c)]);
    }
}

// One row 0.1 0.2 0.4 0.8, looked up along s.
class WrapTest : public TextureTest {
protected:
    double at(TextureWrap wrap, double s, const std::vector<std::pair<std::string, std::string>>& attributes = {}) {
        const std::string file = write_floats("row.exr", 4, 1, 1, {0.125F, 0.25F, 0.5F, 1.0F}, attributes);
        TextureDesc desc = describe(file, TextureColorSpace::Raw, wrap);
        desc.wrap_t = TextureWrap::Clamp;
        return open(desc).lookup_channel(0, s, 0.5, 0);
    }
};

TEST_F(WrapTest, AllAgreeInside) {
    for (const TextureWrap wrap : {TextureWrap::Black, TextureWrap::Clamp, TextureWrap::Repeat, TextureWrap::Mirror}) {
        EXPECT_NEAR(at(wrap, 0.125), 0.125, kTolerance);
        EXPECT_NEAR(at(wrap, 0.875), 1.0, kTolerance);
        EXPECT_NEAR(at(wrap, 0.5), 0.375, kTolerance);
    }
}

TEST_F(WrapTest, Black) {
    EXPECT_NEAR(at(TextureWrap::Black, 0.0), 0.0625, kTolerance);  // half of the border texel
    EXPECT_NEAR(at(TextureWrap::Black, 1.0), 0.5, kTolerance);
    EXPECT_EQ(at(TextureWrap::Black, -0.125), 0);
    EXPECT_EQ(at(TextureWrap::Black, 1.125), 0);
    EXPECT_EQ(at(TextureWrap::Black, 1e9), 0);
}

TEST_F(WrapTest, Clamp) {
    EXPECT_NEAR(at(TextureWrap::Clamp, 0.0), 0.125, kTolerance);
    EXPECT_NEAR(at(TextureWrap::Clamp, -7.3), 0.125, kTolerance);
    EXPECT_NEAR(at(TextureWrap::Clamp, 1.0), 1.0, kTolerance);
    EXPECT_NEAR(at(TextureWrap::Clamp, 1e9), 1.0, kTolerance);
}

TEST_F(WrapTest, Repeat) {
    EXPECT_NEAR(at(TextureWrap::Repeat, 0.0), 0.5625, kTolerance);  // between the last and the first
    EXPECT_NEAR(at(TextureWrap::Repeat, 1.375), 0.25, kTolerance);
    EXPECT_NEAR(at(TextureWrap::Repeat, -0.125), 1.0, kTolerance);
    EXPECT_NEAR(at(TextureWrap::Repeat, -2.625), 0.25, kTolerance);
}

TEST_F(WrapTest, Mirror) {
    EXPECT_NEAR(at(TextureWrap::Mirror, 0.0), 0.125, kTolerance);
    EXPECT_NEAR(at(TextureWrap::Mirror, -0.375), 0.25, kTolerance);
    EXPECT_NEAR(at(TextureWrap::Mirror, 1.125), 1.0, kTolerance);
    EXPECT_NEAR(at(TextureWrap::Mirror, 1.625), 0.25, kTolerance);
    EXPECT_NEAR(at(TextureWrap::Mirror, 2.375), 0.25, kTolerance);
}

TEST_F(WrapTest, MetadataDecidesElseBlack) {
    EXPECT_NEAR(at(TextureWrap::UseMetadata, 1.375), 0, kTolerance);
    EXPECT_NEAR(at(TextureWrap::UseMetadata, 1.375, {{"wrapmodes", "periodic,clamp"}}), 0.25, kTolerance);
    EXPECT_NEAR(at(TextureWrap::UseMetadata, 1.625, {{"wrapmodes", "mirror,clamp"}}), 0.25, kTolerance);
    EXPECT_NEAR(at(TextureWrap::UseMetadata, 1.625, {{"wrapmodes", "clamp"}}), 1.0, kTolerance);
    EXPECT_NEAR(at(TextureWrap::Repeat, 1.375, {{"wrapmodes", "clamp"}}), 0.25, kTolerance);
}

TEST_F(TextureTest, SAndTWrapEachInItsOwnWay) {
    TextureDesc desc = describe(four_colors());
    desc.wrap_s = TextureWrap::Repeat;
    desc.wrap_t = TextureWrap::Black;
    const TextureSet textures = open(desc);
    expect_value(textures.lookup(0, 1.25, 0.25), {0, 0, 1, 1});
    expect_value(textures.lookup(0, 0.25, 1.25), {0, 0, 0, 0});
    expect_value(textures.lookup(0, 0.25, -0.25), {0, 0, 0, 0});
}

// ------------------------------------------------------------------------------------------- what texels mean

TEST_F(TextureTest, SrgbIsDecodedExactlyForEveryCode) {
    std::vector<std::uint8_t> codes;
    for (int code = 0; code < 256; ++code) codes.push_back(static_cast<std::uint8_t>(code));
    const TextureSet textures = open(describe(write_bytes("ramp.png", 256, 1, 1, codes), TextureColorSpace::Srgb));
    for (int code = 0; code < 256; ++code) {
        const double expected = srgb_decode(code / 255.0);
        // s falls beside the texel's centre by rounding: the neighbour is at most 1 away, the position 256 * 2^-53
        expect_value(textures.lookup(0, (code + 0.5) / 256, 0.5), {expected, expected, expected, 1}, 1e-13);
    }
}

TEST_F(TextureTest, TexelsAreDecodedBeforeTheyAreFiltered) {
    const TextureSet textures =
        open(describe(write_bytes("two.png", 2, 1, 3, {0, 0, 0, 255, 255, 255}), TextureColorSpace::Srgb));
    expect_value(textures.lookup(0, 0.5, 0.5), {0.5, 0.5, 0.5, 1});  // encoded first it would be 0.214
}

TEST_F(TextureTest, AlphaIsNeitherDecodedNorMultipliedIn) {
    const TextureDesc desc = describe(write_bytes("rgba.png", 1, 1, 4, {255, 128, 0, 64}), TextureColorSpace::Srgb);
    expect_value(open(desc).lookup(0, 0.5, 0.5), {1, srgb_decode(128 / 255.0), 0, 64 / 255.0});
    TextureDesc raw = desc;
    raw.color_space = TextureColorSpace::Raw;
    expect_value(open(raw).lookup(0, 0.5, 0.5), {1, 128 / 255.0, 0, 64 / 255.0});
}

TEST_F(TextureTest, SixteenBitSrgb) {
    const std::string file = write<std::uint16_t>("deep.png", 1, 1, 3, {65535, 32768, 600}, OIIO::TypeDesc::UINT16);
    expect_value(open(describe(file, TextureColorSpace::Srgb)).lookup(0, 0.5, 0.5),
                 {1, srgb_decode(32768 / 65535.0), 600 / 65535.0 / 12.92, 1});
}

TEST_F(TextureTest, HalfAndFloatKeepTheirValues) {
    const std::vector<float> values{0.1F, 2000.0F, -3.5F};
    const std::string floats = write_floats("float.exr", 1, 1, 3, values);
    expect_value(open(describe(floats)).lookup(0, 0.5, 0.5), {static_cast<double>(0.1F), 2000, -3.5, 1});
    OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeDesc::HALF);
    const std::string halves = write_spec("half.exr", spec, values, OIIO::TypeDesc::FLOAT);
    expect_value(open(describe(halves)).lookup(0, 0.5, 0.5), {1638.0 / 16384, 2000, -3.5, 1});
}

TEST_F(TextureTest, ChannelsThatAreMissing) {
    const std::string one = write_bytes("one.png", 1, 1, 1, {51});
    expect_value(open(describe(one)).lookup(0, 0.5, 0.5), {0.2, 0.2, 0.2, 1});
    const std::string two = write_bytes("two.png", 1, 1, 2, {51, 102});
    expect_value(open(describe(two)).lookup(0, 0.5, 0.5), {0.2, 0.2, 0.2, 0.4});
}

TEST_F(TextureTest, ChannelsBeyondFourDoNotDisturb) {
    OIIO::ImageSpec spec(1, 1, 6, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"R", "G", "B", "depth.Z", "A", "id"};
    const std::string file =
        write_spec<float>("many.exr", spec, {0.5F, 0.25F, 0.125F, 9, 0.75F, 7}, OIIO::TypeDesc::FLOAT);
    expect_value(open(describe(file)).lookup(0, 0.5, 0.5), {0.5, 0.25, 0.125, 0.75});
}

TEST_F(TextureTest, AutoFollowsMetadataThenEightBitColor) {
    const double half = 128 / 255.0;
    const auto red = [&](const std::string& file) {
        return open(describe(file, TextureColorSpace::Auto)).lookup_channel(0, 0.5, 0.5, 0);
    };
    EXPECT_NEAR(red(write_bytes("rgb.png", 1, 1, 3, {128, 128, 128})), srgb_decode(half), kTolerance);
    EXPECT_NEAR(red(write_bytes("rgba.png", 1, 1, 4, {128, 128, 128, 255})), srgb_decode(half), kTolerance);
    EXPECT_NEAR(red(write_bytes("grey.png", 1, 1, 1, {128})), half, kTolerance);
    EXPECT_NEAR(red(write_bytes("rgb.tif", 1, 1, 3, {128, 128, 128})), srgb_decode(half), kTolerance);
    EXPECT_NEAR(red(write_bytes("grey.tif", 1, 1, 1, {128})), half, kTolerance);
    EXPECT_NEAR(red(write_bytes("tagged_grey.png", 1, 1, 1, {128}, {{"oiio:ColorSpace", "sRGB"}})), srgb_decode(half),
                kTolerance);
    EXPECT_NEAR(red(write_bytes("linear.png", 1, 1, 3, {128, 128, 128}, {{"oiio:ColorSpace", "Linear"}})), half,
                kTolerance);
    const std::vector<std::uint16_t> deep{32768, 32768, 32768};
    const double deep_half = 32768 / 65535.0;
    EXPECT_NEAR(red(write("deep.png", 1, 1, 3, deep, OIIO::TypeDesc::UINT16)), deep_half, kTolerance);
    EXPECT_NEAR(red(write("tagged_deep.png", 1, 1, 3, deep, OIIO::TypeDesc::UINT16, {{"oiio:ColorSpace", "sRGB"}})),
                srgb_decode(deep_half), kTolerance);
    EXPECT_NEAR(red(write_floats("x.exr", 1, 1, 3, {0.5F, 0.5F, 0.5F})), 0.5, kTolerance);
}

TEST_F(TextureTest, ScaleAndBiasApplyLast) {
    TextureDesc desc = describe(write_bytes("normal.png", 1, 1, 4, {255, 0, 128, 255}));
    desc.scale = {2, 2, 4, 0.5};
    desc.bias = {-1, -1, 0.25, 0.125};
    expect_value(open(desc).lookup(0, 0.5, 0.5), {1, -1, 4 * 128 / 255.0 + 0.25, 0.625});
    desc.wrap_s = TextureWrap::Black;
    expect_value(open(desc).lookup(0, 5, 0.5), {-1, -1, 0.25, 0.125});
}

TEST_F(TextureTest, StTransformComesFirst) {
    TextureDesc desc = describe(four_colors());
    desc.st_transform = {0, 1, 0.25, 1, 0, -0.5};  // s' = t + 0.25, t' = s - 0.5
    const TextureSet textures = open(desc);
    expect_value(textures.lookup(0, 0.75, 0.0), {0, 0, 1, 1});  // at (0.25, 0.25)
    expect_value(textures.lookup(0, 1.25, 0.0), {1, 0, 0, 1});  // at (0.25, 0.75)
    expect_value(textures.lookup(0, 0.75, 0.5), {1, 1, 1, 1});  // at (0.75, 0.25)
}

TEST_F(TextureTest, TheDataWindowIsPartOfTheImage) {
    OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeDesc::FLOAT);
    spec.x = 11;
    spec.y = 20;
    spec.full_x = 10;
    spec.full_y = 20;
    spec.full_width = spec.full_height = 2;
    const std::string file = write_spec<float>("window.exr", spec, {0.5F, 0.25F, 0.125F}, OIIO::TypeDesc::FLOAT);
    const TextureSet textures = open(describe(file));
    expect_value(textures.lookup(0, 0.75, 0.75), {0.5, 0.25, 0.125, 1});  // upper right
    expect_value(textures.lookup(0, 0.25, 0.75), {0, 0, 0, 0});
    expect_value(textures.lookup(0, 0.75, 0.25), {0, 0, 0, 0});
}

TEST_F(TextureTest, CoordinatesThatAreNotNumbersGiveTheFallback) {
    TextureDesc desc = describe(four_colors());
    desc.fallback = {0.1, 0.2, 0.3, 0.4};
    const TextureSet textures = open(desc);
    EXPECT_EQ(textures.lookup(0, std::nan(""), 0.5), desc.fallback);
    EXPECT_EQ(textures.lookup(0, 0.5, std::numeric_limits<double>::infinity()), desc.fallback);
}

// ------------------------------------------------------------------------------------------------ tiles, threads

TEST_F(TextureTest, TilesAreFoundInTiledFiles) {
    constexpr int size = 70;  // the last tiles are partial
    OIIO::ImageSpec spec(size, size, 1, OIIO::TypeDesc::FLOAT);
    spec.tile_width = spec.tile_height = 16;
    std::vector<float> values;
    for (int i = 0; i < size * size; ++i) values.push_back(static_cast<float>(i));
    const TextureSet textures = open(describe(write_spec("tiled.exr", spec, values, OIIO::TypeDesc::FLOAT)));
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double value = textures.lookup_channel(0, (x + 0.5) / size, 1 - (y + 0.5) / size, 0);
            EXPECT_NEAR(value, y * size + x, 1e-9);  // values to 4900, neighbouring rows 70 apart
        }
    }
}

TEST_F(TextureTest, TheMemoryLimitHolds) {
    constexpr int size = 1024;
    constexpr int tile_bytes = 64 * 64 * 4;
    OIIO::ImageSpec spec(size, size, 1, OIIO::TypeDesc::FLOAT);
    spec.tile_width = spec.tile_height = 64;
    std::vector<float> values;
    for (int i = 0; i < size * size; ++i) values.push_back(static_cast<float>(i % 997));
    const std::string file = write_spec("large.exr", spec, values, OIIO::TypeDesc::FLOAT);
    // 10 MB is the least OpenImageIO accepts; four files are 16 MB.
    std::vector<TextureDesc> descriptions;
    for (const char* name : {"a.exr", "b.exr", "c.exr", "d.exr"}) {
        std::filesystem::copy_file(file, directory_.file(name));
        descriptions.push_back(describe(directory_.file(name)));
    }
    const TextureSet textures(descriptions, 10);
    for (int texture = 0; texture < 4; ++texture) {
        for (int y = 0; y < size; y += 64) {
            for (int x = 0; x < size; x += 64) {
                const double s = (x + 0.5) / size;
                const double t = 1 - (y + 0.5) / size;
                EXPECT_NEAR(textures.lookup_channel(texture, s, t, 0), (y * size + x) % 997, 1e-9);
            }
        }
    }
    EXPECT_GT(textures.memory_used(), 1 << 20);
    EXPECT_LE(textures.memory_used(), 10 * (1 << 20) + (TextureCache::kHeldTiles + 1) * (tile_bytes + 256));
    EXPECT_EQ(textures.file_count(), 4U);
}

TEST_F(TextureTest, ManyThreadsReadTheSame) {
    constexpr int size = 64;
    std::vector<float> values;
    for (int i = 0; i < size * size; ++i) values.push_back(static_cast<float>(i));
    std::vector<TextureDesc> descriptions;
    for (int i = 0; i < 12; ++i) {  // more than a thread holds
        OIIO::ImageSpec spec(size, size, 1, OIIO::TypeDesc::FLOAT);
        spec.tile_width = spec.tile_height = 16;
        const std::string name = "t" + std::to_string(i) + ".exr";
        descriptions.push_back(describe(write_spec(name, spec, values, OIIO::TypeDesc::FLOAT)));
    }
    const TextureSet textures(descriptions);
    std::vector<int> wrong(4, 0);
    std::vector<std::thread> threads;
    for (int& count : wrong) {
        threads.emplace_back([&] {
            for (int i = 0; i < 20000; ++i) {
                const int x = (i * 7) % size;
                const int y = (i * 13) % size;
                const double value = textures.lookup_channel(i % 12, (x + 0.5) / size, 1 - (y + 0.5) / size, 0);
                if (std::abs(value - (y * size + x)) > 1e-9) ++count;
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

TEST_F(TextureTest, SetsLiveSideBySide) {
    const TextureDesc desc = describe(four_colors());
    auto first = std::make_unique<TextureSet>(std::vector{desc});
    const TextureSet second = open(desc);
    expect_value(first->lookup(0, 0.25, 0.25), {0, 0, 1, 1});
    expect_value(second.lookup(0, 0.25, 0.25), {0, 0, 1, 1});
    first.reset();
    const TextureSet third = open(desc);
    expect_value(third.lookup(0, 0.25, 0.25), {0, 0, 1, 1});
    expect_value(second.lookup(0, 0.25, 0.25), {0, 0, 1, 1});
}

TEST_F(TextureTest, AFileUsedTwiceIsOpenedOnce) {
    const std::string file = four_colors();
    TextureDesc scaled = describe(file);
    scaled.scale = {0.5, 0.5, 0.5, 0.5};
    const TextureSet textures(std::vector{describe(file), scaled});
    EXPECT_EQ(textures.size(), 2U);
    EXPECT_EQ(textures.file_count(), 1U);
    expect_value(textures.lookup(0, 0.25, 0.25), {0, 0, 1, 1});
    expect_value(textures.lookup(1, 0.25, 0.25), {0, 0, 0.5, 0.5});
}

TEST_F(TextureTest, NoTexturesAreASetToo) { EXPECT_EQ(TextureSet(std::vector<TextureDesc>{}).size(), 0U); }

// --------------------------------------------------------------------------------------------------------- UDIM

TEST_F(TextureTest, UdimTilesAreFilesInARow) {
    write_bytes("skin.1001.png", 1, 1, 3, {255, 0, 0});
    write_bytes("skin.1002.png", 1, 1, 3, {0, 255, 0});
    write_bytes("skin.1011.png", 1, 1, 3, {0, 0, 255});
    TextureDesc desc = describe(directory_.file("skin.<UDIM>.png"));
    desc.fallback = {0.1, 0.2, 0.3, 0.4};
    const TextureSet textures = open(desc);
    EXPECT_EQ(textures.file_count(), 3U);
    expect_value(textures.lookup(0, 0.5, 0.5), {1, 0, 0, 1});
    expect_value(textures.lookup(0, 0.999, 0.5), {1, 0, 0, 1});  // a tile does not bleed into its neighbour
    expect_value(textures.lookup(0, 1.0, 0.5), {0, 1, 0, 1});
    expect_value(textures.lookup(0, 0.5, 1.5), {0, 0, 1, 1});
    for (const auto& [s, t] : {std::pair{1.5, 1.5}, {-0.5, 0.5}, {0.5, -0.5}, {10.5, 0.5}, {0.5, 10.5}, {1e300, 0.5}}) {
        EXPECT_EQ(textures.lookup(0, s, t), desc.fallback) << s << " " << t;
    }
}

TEST_F(TextureTest, UdimWithoutAnyTileIsRefused) {
    const std::string file = directory_.file("none.<UDIM>.png");
    EXPECT_EQ(refusal(describe(file)), "texture /Looks/Texture: no tile of '" + file + "' exists");
}

// ------------------------------------------------------------------------------------------------------ failures

TEST_F(TextureTest, WhatCannotBeReadIsNamedAtOnce) {
    const std::string missing = directory_.file("missing.png");
    EXPECT_EQ(refusal(describe(missing)), "texture /Looks/Texture: cannot read '" + missing + "': it does not exist");
    EXPECT_EQ(refusal(describe(directory_.path().string())),
              "texture /Looks/Texture: cannot read '" + directory_.path().string() + "': it is a directory");
    EXPECT_EQ(refusal(describe("")), "texture /Looks/Texture: cannot read '': no file is named");
    std::ofstream(directory_.file("noise.png")) << "this is not a picture";
    std::ofstream(directory_.file("empty.exr")) << "";
    for (const char* name : {"noise.png", "empty.exr"}) {
        const std::string start = "texture /Looks/Texture: cannot read '" + directory_.file(name) + "': ";
        const std::string message = refusal(describe(directory_.file(name)));
        EXPECT_TRUE(message.starts_with(start) && message.size() > start.size()) << message;
    }
}

TEST_F(TextureTest, AFileCutShortIsNoticedAtOnce) {
    std::vector<std::uint8_t> noise;
    std::uint32_t state = 1;
    for (int i = 0; i < 64 * 64 * 3; ++i) {
        state = state * 1664525U + 1013904223U;
        noise.push_back(static_cast<std::uint8_t>(state >> 24));
    }
#ifdef __SANITIZE_ADDRESS__
    const std::vector<std::string> names{"cut.exr"};  // OpenImageIO jumps out of libpng past a string, which leaks
#else
    const std::vector<std::string> names{"cut.png", "cut.exr"};
#endif
    for (const std::string& name : names) {
        const std::string file = write(name, 64, 64, 3, noise, OIIO::TypeDesc::UINT8);
        ASSERT_EQ(refusal(describe(file)), "accepted") << name;
        std::filesystem::resize_file(file, std::filesystem::file_size(file) * 2 / 3);
        const std::string message = refusal(describe(file));
        EXPECT_TRUE(message.starts_with("texture /Looks/Texture: cannot read '" + file + "': ")) << name << message;
    }
}

TEST_F(TextureTest, AFileThatGoesBadLaterGivesTheFallback) {
    constexpr int size = 1024;
    OIIO::ImageSpec spec(size, size, 1, OIIO::TypeDesc::FLOAT);
    spec.tile_width = spec.tile_height = 64;
    spec.attribute("compression", "none");
    const std::vector<float> values(static_cast<std::size_t>(size * size), 0.5F);
    TextureDesc desc = describe(write_spec("fading.exr", spec, values, OIIO::TypeDesc::FLOAT));
    desc.fallback = {0.1, 0.2, 0.3, 0.4};
    const TextureSet textures = open(desc);
    std::filesystem::resize_file(desc.file, 20000);
    EXPECT_EQ(textures.failed_lookups(), 0U);
    EXPECT_EQ(textures.lookup(0, 0.5, 0.5), desc.fallback);
    EXPECT_EQ(textures.failed_lookups(), 1U);
}

}  // namespace
}  // namespace etendue
