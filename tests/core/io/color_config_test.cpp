#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <etendue/display.h>
#include <etendue/error.h>

#include "core/io/temporary_directory.h"
#include "io/builtin_config.h"

namespace etendue {
namespace {

using Rgb3 = std::array<float, 3>;

// A display value is a handful of float operations: matrix products that OpenColorIO folds into one, whose rows sum to
// one with errors below 4 ulp, then a power. 16 ulp of 1 is four times less than half a 16-bit code.
constexpr double kFloatTolerance = 16 * 5.96e-8;

/// $OCIO as given (null: not set) for the life of the object.
class OcioVariable {
public:
    explicit OcioVariable(const char* value) {
        const char* before = getenv("OCIO");
        had_before_ = before != nullptr;
        if (had_before_) before_ = before;
        if (value) {
            setenv("OCIO", value, 1);
        } else {
            unsetenv("OCIO");
        }
    }
    ~OcioVariable() {
        if (had_before_) {
            setenv("OCIO", before_.c_str(), 1);
        } else {
            unsetenv("OCIO");
        }
    }
    OcioVariable(const OcioVariable&) = delete;
    OcioVariable& operator=(const OcioVariable&) = delete;

private:
    bool had_before_ = false;
    std::string before_;
};

class ColorConfigTest : public testing::Test {
protected:
    static Rgb3 apply(const ColorConfig& config, Rgb3 rgb, const std::string& display, const std::string& view) {
        config.apply(rgb, display, view);
        return rgb;
    }

    std::string write_file(const std::string& name, std::string_view text) {
        std::ofstream(directory_.file(name)) << text;
        return directory_.file(name);
    }

    OcioVariable no_ocio_{nullptr};
    TemporaryDirectory directory_;
};

template <typename Exception, typename Function>
std::string message_of(Function function) {
    try {
        function();
    } catch (const Exception& error) {
        return error.what();
    }
    return "nothing was thrown";
}

/// OpenColorIO joins line and power with equal slopes: 12.9232 where the standard rounds to 12.92, 7e-6 apart at most.
double srgb_encode(double x) {
    return x <= 0.0030399346397784327 ? 12.923210180787853 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

void expect_near(const Rgb3& actual, const std::array<double, 3>& expected, double tolerance) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance) << "channel " << c;
}

// --------------------------------------------------------------------------------------------------- what exists

TEST_F(ColorConfigTest, BuiltInHasItsDisplaysAndViews) {
    const ColorConfig config;
    EXPECT_EQ(config.source(), "built-in");
    EXPECT_EQ(config.displays(), (std::vector<std::string>{"sRGB", "Rec.1886", "Display P3", "P3-D65"}));
    for (const std::string& display : config.displays()) {
        EXPECT_EQ(config.views(display), (std::vector<std::string>{"ACES 1.0 SDR", "Un-tone-mapped", "Raw"}));
        EXPECT_EQ(config.default_view(display), "ACES 1.0 SDR");
    }
    EXPECT_EQ(config.default_display(), "sRGB");
}

TEST_F(ColorConfigTest, EmptyNamesAreTheDefaults) {
    const ColorConfig config;
    const Rgb3 color{0.3F, 0.1F, 0.6F};
    EXPECT_EQ(apply(config, color, "", ""), apply(config, color, "sRGB", "ACES 1.0 SDR"));
    EXPECT_NE(apply(config, color, "", ""), apply(config, color, "", "Un-tone-mapped"));
}

TEST_F(ColorConfigTest, NamesMatchWhateverTheirCase) {
    const ColorConfig config;
    const Rgb3 color{0.3F, 0.1F, 0.6F};
    EXPECT_EQ(apply(config, color, "SRGB", "raw"), color);
    EXPECT_EQ(config.views("display p3").size(), 3U);
}

TEST_F(ColorConfigTest, UnknownNamesSayWhatExists) {
    const ColorConfig config;
    Rgb3 color{};
    EXPECT_EQ(
        message_of<SettingsError>([&] { config.apply(color, "CRT", ""); }),
        "no display 'CRT' in the OpenColorIO configuration 'built-in'; it has: sRGB, Rec.1886, Display P3, P3-D65");
    EXPECT_EQ(message_of<SettingsError>([&] { config.apply(color, "sRGB", "Filmic"); }),
              "no view 'Filmic' for the display 'sRGB' in the OpenColorIO configuration 'built-in'; it has: "
              "ACES 1.0 SDR, Un-tone-mapped, Raw");
    EXPECT_THROW((void)config.views("CRT"), SettingsError);
    EXPECT_THROW((void)config.default_view("CRT"), SettingsError);
    EXPECT_THROW((void)config.encodes_srgb("CRT", ""), SettingsError);
}

TEST_F(ColorConfigTest, OnlyTriplesAreTaken) {
    const ColorConfig config;
    std::vector<float> values(4);
    EXPECT_THROW(config.apply(values), SettingsError);
    config.apply({});
}

TEST_F(ColorConfigTest, KnowsWhatIsSrgb) {
    const ColorConfig config;
    EXPECT_TRUE(config.encodes_srgb());
    EXPECT_TRUE(config.encodes_srgb("sRGB", "Un-tone-mapped"));
    EXPECT_FALSE(config.encodes_srgb("sRGB", "Raw"));
    EXPECT_FALSE(config.encodes_srgb("Rec.1886", ""));
    EXPECT_FALSE(config.encodes_srgb("Display P3", ""));
}

// ------------------------------------------------------------------------------------------------------- values

TEST_F(ColorConfigTest, UnToneMappedSrgbIsTheSrgbCurve) {
    const ColorConfig config;
    for (const float value : {0.0F, 0.002F, 0.18F, 0.5F, 1.0F}) {
        const double expected = srgb_encode(static_cast<double>(value));
        expect_near(apply(config, {value, value, value}, "sRGB", "Un-tone-mapped"), {expected, expected, expected},
                    kFloatTolerance);
    }
    expect_near(apply(config, {0.8F, 0.2F, 0.05F}, "sRGB", "Un-tone-mapped"),
                {srgb_encode(0.8), srgb_encode(0.2), srgb_encode(0.05)}, kFloatTolerance);
}

TEST_F(ColorConfigTest, RawIsTheNumbersThemselves) {
    const ColorConfig config;
    const Rgb3 color{-0.5F, 0.18F, 7.25F};
    for (const std::string& display : config.displays()) EXPECT_EQ(apply(config, color, display, "Raw"), color);
}

TEST_F(ColorConfigTest, Rec1886IsGamma24) {
    const ColorConfig config;
    const auto encode = [](double x) { return std::pow(x, 1 / 2.4); };
    expect_near(apply(config, {0.8F, 0.2F, 0.05F}, "Rec.1886", "Un-tone-mapped"),
                {encode(0.8), encode(0.2), encode(0.05)}, kFloatTolerance);
}

/// Linear P3 of linear Rec.709, from the primaries of both and their common white: (rows of inv(P3) * Rec.709).
constexpr double kP3FromRec709[3][3] = {{0.822461968714363, 0.177538031285638, 0.0},
                                        {0.033194198850962, 0.966805801149038, 0.0},
                                        {0.017082630721120, 0.072397440663963, 0.910519928614917}};

std::array<double, 3> p3_from_rec709(const Rgb3& rgb, double (*encode)(double)) {
    std::array<double, 3> result{};
    for (std::size_t row = 0; row < 3; ++row) {
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c) sum += kP3FromRec709[row][c] * static_cast<double>(rgb[c]);
        result[row] = encode(sum);
    }
    return result;
}

TEST_F(ColorConfigTest, DisplayP3HasP3PrimariesAndTheSrgbCurve) {
    const ColorConfig config;
    const Rgb3 color{0.8F, 0.2F, 0.05F};
    expect_near(apply(config, color, "Display P3", "Un-tone-mapped"), p3_from_rec709(color, srgb_encode),
                kFloatTolerance);
}

TEST_F(ColorConfigTest, P3D65HasP3PrimariesAndGamma26) {
    const ColorConfig config;
    const Rgb3 color{0.8F, 0.2F, 0.05F};
    expect_near(apply(config, color, "P3-D65", "Un-tone-mapped"),
                p3_from_rec709(color, [](double x) { return std::pow(x, 1 / 2.6); }), kFloatTolerance);
}

// The ACES 1.x tone scale takes 0.18 to 4.8 cd/m^2 and 0.18 * 2^6.5 to 48 cd/m^2 (the anchors of its 48 nit spline);
// code values begin at 0.02 cd/m^2. The video transforms then raise luminance to 0.9811 for the dim surround. None of
// the chromatic steps touches a neutral.
double aces_cinema_linear(double nits) { return (nits - 0.02) / (48 - 0.02); }
double aces_video_linear(double nits) { return std::pow(aces_cinema_linear(nits), 0.9811); }
// The spline is tabulated on half floats and interpolated, with relative steps of 2^-10: quadratic terms are below
// 1e-6.
constexpr double kAcesTolerance = 5e-6;

TEST_F(ColorConfigTest, AcesSdrTakesMiddleGreyToTenPercent) {
    const ColorConfig config;
    const Rgb3 grey{0.18F, 0.18F, 0.18F};
    const double srgb = srgb_encode(aces_video_linear(4.8));
    EXPECT_NEAR(srgb, 0.355954, 1e-6);
    expect_near(apply(config, grey, "sRGB", "ACES 1.0 SDR"), {srgb, srgb, srgb}, kAcesTolerance);
    const double rec1886 = std::pow(aces_video_linear(4.8), 1 / 2.4);
    expect_near(apply(config, grey, "Rec.1886", "ACES 1.0 SDR"), {rec1886, rec1886, rec1886}, kAcesTolerance);
    const double p3d65 = std::pow(aces_cinema_linear(4.8), 1 / 2.6);
    expect_near(apply(config, grey, "P3-D65", "ACES 1.0 SDR"), {p3d65, p3d65, p3d65}, kAcesTolerance);
}

TEST_F(ColorConfigTest, AcesSdrReachesWhiteSixAndAHalfStopsAboveGrey) {
    const ColorConfig config;
    const auto bright = static_cast<float>(0.18 * std::exp2(6.5));
    expect_near(apply(config, {bright, bright, bright}, "sRGB", "ACES 1.0 SDR"), {1, 1, 1}, kAcesTolerance);
    expect_near(apply(config, {0, 0, 0}, "sRGB", "ACES 1.0 SDR"), {0, 0, 0}, kAcesTolerance);
}

// A saturated colour, which passes every chromatic step: the value that the published ACES CG configuration v2.1.0
// gives (computed with OpenColorIO 2.6.0).
TEST_F(ColorConfigTest, AcesSdrOfASaturatedColorIsThatOfTheAcesConfiguration) {
    const ColorConfig config;
    expect_near(apply(config, {0.8F, 0.2F, 0.05F}, "sRGB", "ACES 1.0 SDR"), {0.7609965, 0.4079398, 0.1717823},
                kAcesTolerance);
    expect_near(apply(config, {0.8F, 0.2F, 0.05F}, "Display P3", "ACES 1.0 SDR"), {0.7142618, 0.4259970, 0.2265737},
                kAcesTolerance);
}

// --------------------------------------------------------------------------------------------- where it comes from

TEST_F(ColorConfigTest, TheConfigurationWorksAsAFileToo) {
    const std::string file = write_file("copy.ocio", builtin_ocio_config());
    const ColorConfig from_file(file);
    const ColorConfig built_in;
    EXPECT_EQ(from_file.source(), file);
    EXPECT_EQ(from_file.displays(), built_in.displays());
    const Rgb3 color{0.8F, 0.2F, 0.05F};
    for (const std::string& display : built_in.displays()) {
        for (const std::string& view : built_in.views(display)) {
            EXPECT_EQ(apply(from_file, color, display, view), apply(built_in, color, display, view));
        }
    }
}

/// Works in ACEScg, does not know linear Rec.709, and has one display of its own.
constexpr const char* kForeignConfig = R"(ocio_profile_version: 2.1
roles: {scene_linear: acescg, aces_interchange: ap0, default: acescg}
file_rules: [!<Rule> {name: Default, colorspace: default}]
displays:
  Screen: [!<View> {name: Linear, colorspace: acescg}, !<View> {name: Numbers, colorspace: ap0}]
colorspaces:
  - !<ColorSpace> {name: ap0}
  - !<ColorSpace>
    name: acescg
    to_scene_reference: !<BuiltinTransform> {style: ACEScg_to_ACES2065-1}
)";

TEST_F(ColorConfigTest, OcioVariableNamesTheFileAndAnArgumentOverrulesIt) {
    const std::string foreign = write_file("foreign.ocio", kForeignConfig);
    const OcioVariable variable(foreign.c_str());
    const ColorConfig config;
    EXPECT_EQ(config.source(), foreign);
    EXPECT_EQ(config.displays(), std::vector<std::string>{"Screen"});
    const std::string own = write_file("own.ocio", builtin_ocio_config());
    EXPECT_EQ(ColorConfig(own).source(), own);
    const OcioVariable empty("");
    EXPECT_EQ(ColorConfig().source(), "built-in");
}

TEST_F(ColorConfigTest, AConfigurationWithoutRec709IsEnteredByItsInterchangeRole) {
    const ColorConfig config(write_file("foreign.ocio", kForeignConfig));
    // ACEScg of Rec.709 red (Bradford-adapted), as published with ACES.
    expect_near(apply(config, {1, 0, 0}, "Screen", "Linear"), {0.613097, 0.070194, 0.020616}, 1e-6);
}

TEST_F(ColorConfigTest, AConfigurationThatCannotBeEnteredIsNamed) {
    std::string text = kForeignConfig;
    text.replace(text.find(", aces_interchange: ap0"), std::string(", aces_interchange: ap0").size(), "");
    const std::string file = write_file("island.ocio", text);
    const ColorConfig config(file);
    Rgb3 color{};
    const std::string message = message_of<FileError>([&] { config.apply(color); });
    EXPECT_NE(message.find("'" + file + "' cannot turn linear Rec.709 into view 'Linear'"), std::string::npos)
        << message;
}

TEST_F(ColorConfigTest, BadFilesAreNamed) {
    const std::string missing = directory_.file("missing.ocio");
    const std::string broken = write_file("broken.ocio", "ocio_profile_version: 2.1\ncolorspaces: [}\n");
    const std::string later = write_file("later.ocio", "ocio_profile_version: 99\n");
    const std::string no_display = write_file("no_display.ocio", R"(ocio_profile_version: 2.1
roles: {default: raw}
file_rules: [!<Rule> {name: Default, colorspace: default}]
colorspaces: [!<ColorSpace> {name: raw}]
)");
    for (const std::string& file : {missing, broken, later, no_display, directory_.path().string()}) {
        const std::string message = message_of<FileError>([&] { const ColorConfig config(file); });
        EXPECT_NE(message.find("'" + file + "'"), std::string::npos) << message;
        const OcioVariable variable(file.c_str());
        const std::string same = message_of<FileError>([] { const ColorConfig config; });
        EXPECT_NE(same.find("'" + file + "'"), std::string::npos) << same;
    }
    const OcioVariable variable(missing.c_str());
    EXPECT_NE(message_of<FileError>([] { const ColorConfig config; }).find("$OCIO"), std::string::npos);
}

TEST_F(ColorConfigTest, NothingIsPrinted) {
    std::string text(builtin_ocio_config());
    text += "\nsomething_unheard_of: 1\n";  // OpenColorIO warns about it
    const std::string file = write_file("odd.ocio", text);
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const ColorConfig config(file);
    Rgb3 color{};
    config.apply(color);
    message_of<FileError>([&] { const ColorConfig missing(file + "x"); });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST_F(ColorConfigTest, Moves) {
    ColorConfig first;
    ColorConfig second(std::move(first));
    EXPECT_EQ(second.source(), "built-in");
}

}  // namespace
}  // namespace etendue
