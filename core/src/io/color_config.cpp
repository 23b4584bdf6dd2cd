#include <etendue/display.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <mutex>
#include <sstream>
#include <string_view>
#include <utility>

#include <OpenColorIO/OpenColorIO.h>

#include <etendue/error.h>

#include "io/builtin_config.h"

namespace etendue {

namespace OCIO = OCIO_NAMESPACE;

namespace {

/// OpenColorIO writes its messages to stderr, at a level that is global to the process; a library must not print. For
/// the time of one call the level is lowered and then put back. OCIO_LOGGING_LEVEL in the environment overrules us.
class QuietOcio {
public:
    QuietOcio() : lock_(mutex()), level_(OCIO::GetLoggingLevel()) { OCIO::SetLoggingLevel(OCIO::LOGGING_LEVEL_NONE); }
    ~QuietOcio() { OCIO::SetLoggingLevel(level_); }
    QuietOcio(const QuietOcio&) = delete;
    QuietOcio& operator=(const QuietOcio&) = delete;

private:
    static std::mutex& mutex() {
        static std::mutex instance;
        return instance;
    }
    std::lock_guard<std::mutex> lock_;
    OCIO::LoggingLevel level_;
};

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

std::string join(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
}

/// The entry of `names` that is `name` but for case, which OpenColorIO ignores too; null when there is none.
const std::string* find_name(const std::vector<std::string>& names, const std::string& name) {
    const std::string wanted = lower(name);
    const auto found = std::find_if(names.begin(), names.end(), [&](const auto& n) { return lower(n) == wanted; });
    return found == names.end() ? nullptr : &*found;
}

OCIO::ConstConfigRcPtr load_builtin() {
    std::istringstream text{std::string(builtin_ocio_config())};
    return OCIO::Config::CreateFromStream(text);
}

/// What to load: the file asked for, else $OCIO, else nothing (the built-in configuration).
std::pair<std::string, bool> find_file(const std::string& file) {
    if (!file.empty()) return {file, false};
    const char* variable = std::getenv("OCIO");
    return {variable ? variable : "", true};
}

/// What linear Rec.709 is called: USD's token, then the names of the published ACES, Blender and film configurations.
constexpr const char* kLinearRec709Names[] = {
    "lin_rec709_scene",           "lin_rec709", "Linear Rec.709 (sRGB)",   "Linear Rec.709",
    "Utility - Linear - Rec.709", "lin_srgb",   "Utility - Linear - sRGB", "Linear sRGB",
};

}  // namespace

class ColorConfig::Impl {
public:
    explicit Impl(const std::string& file);

    struct DisplayView {
        std::string display;
        std::string view;
    };
    [[nodiscard]] std::vector<std::string> displays() const;
    [[nodiscard]] std::vector<std::string> views(const std::string& display) const;  ///< of a display that exists
    [[nodiscard]] DisplayView resolve(const std::string& display, const std::string& view) const;
    [[nodiscard]] std::string resolve_display(const std::string& display) const;
    [[nodiscard]] OCIO::ConstCPUProcessorRcPtr processor(const DisplayView& target) const;

    std::string source;
    OCIO::ConstConfigRcPtr config;

private:
    [[nodiscard]] OCIO::ConstProcessorRcPtr find_processor(const DisplayView& target) const;
};

ColorConfig::Impl::Impl(const std::string& file) {
    const auto [path, from_environment] = find_file(file);
    source = path.empty() ? "built-in" : path;
    const QuietOcio quiet;
    try {
        config = path.empty() ? load_builtin() : OCIO::Config::CreateFromFile(path.c_str());
    } catch (const std::exception& error) {
        throw FileError("cannot load the OpenColorIO configuration '" + source + "'" +
                        (from_environment ? " (from $OCIO)" : "") + ": " + error.what());
    }
    if (config->getNumDisplays() == 0) {
        throw FileError("the OpenColorIO configuration '" + source + "' has no display");
    }
}

std::vector<std::string> ColorConfig::Impl::displays() const {
    std::vector<std::string> names;
    for (int i = 0; i < config->getNumDisplays(); ++i) names.emplace_back(config->getDisplay(i));
    return names;
}

std::vector<std::string> ColorConfig::Impl::views(const std::string& display) const {
    std::vector<std::string> names;
    const int count = config->getNumViews(display.c_str());
    for (int i = 0; i < count; ++i) names.emplace_back(config->getView(display.c_str(), i));
    return names;
}

std::string ColorConfig::Impl::resolve_display(const std::string& display) const {
    if (display.empty()) return config->getDefaultDisplay();
    const std::vector<std::string> names = displays();
    if (const std::string* name = find_name(names, display)) return *name;
    throw SettingsError("no display '" + display + "' in the OpenColorIO configuration '" + source +
                        "'; it has: " + join(names));
}

ColorConfig::Impl::DisplayView ColorConfig::Impl::resolve(const std::string& display, const std::string& view) const {
    const std::string found_display = resolve_display(display);
    if (view.empty()) return {found_display, config->getDefaultView(found_display.c_str())};
    const std::vector<std::string> names = views(found_display);
    if (const std::string* found_view = find_name(names, view)) return {found_display, *found_view};
    throw SettingsError("no view '" + view + "' for the display '" + found_display +
                        "' in the OpenColorIO configuration '" + source + "'; it has: " + join(names));
}

OCIO::ConstProcessorRcPtr ColorConfig::Impl::find_processor(const DisplayView& target) const {
    for (const char* name : kLinearRec709Names) {
        if (!config->getColorSpace(name)) continue;
        return config->getProcessor(name, target.display.c_str(), target.view.c_str(), OCIO::TRANSFORM_DIR_FORWARD);
    }
    // It knows the space by another name or not at all; its interchange role tells how to get in all the same.
    const OCIO::ConstProcessorRcPtr to_working_space =
        OCIO::Config::GetProcessorFromConfigs(load_builtin(), kLinearRec709Names[0], config, OCIO::ROLE_SCENE_LINEAR);
    const OCIO::ConstProcessorRcPtr to_display = config->getProcessor(OCIO::ROLE_SCENE_LINEAR, target.display.c_str(),
                                                                      target.view.c_str(), OCIO::TRANSFORM_DIR_FORWARD);
    const OCIO::GroupTransformRcPtr both = OCIO::GroupTransform::Create();
    both->appendTransform(to_working_space->createGroupTransform());
    both->appendTransform(to_display->createGroupTransform());
    return config->getProcessor(both);
}

OCIO::ConstCPUProcessorRcPtr ColorConfig::Impl::processor(const DisplayView& target) const {
    // OpenColorIO's default also swaps in approximate powers and logarithms, which shows in 16-bit files.
    constexpr auto exact =
        static_cast<OCIO::OptimizationFlags>(static_cast<unsigned long>(OCIO::OPTIMIZATION_DEFAULT) &
                                             ~static_cast<unsigned long>(OCIO::OPTIMIZATION_FAST_LOG_EXP_POW));
    const QuietOcio quiet;
    try {
        return find_processor(target)->getOptimizedCPUProcessor(exact);
    } catch (const std::exception& error) {
        throw FileError("the OpenColorIO configuration '" + source + "' cannot turn linear Rec.709 into view '" +
                        target.view + "' of display '" + target.display + "': " + error.what());
    }
}

ColorConfig::ColorConfig(const std::string& file) : impl_(std::make_unique<Impl>(file)) {}
ColorConfig::~ColorConfig() = default;
ColorConfig::ColorConfig(ColorConfig&&) noexcept = default;
ColorConfig& ColorConfig::operator=(ColorConfig&&) noexcept = default;

const std::string& ColorConfig::source() const { return impl_->source; }

std::vector<std::string> ColorConfig::displays() const { return impl_->displays(); }

std::vector<std::string> ColorConfig::views(const std::string& display) const {
    return impl_->views(impl_->resolve_display(display));
}

std::string ColorConfig::default_display() const { return impl_->config->getDefaultDisplay(); }

std::string ColorConfig::default_view(const std::string& display) const {
    return impl_->config->getDefaultView(impl_->resolve_display(display).c_str());
}

bool ColorConfig::encodes_srgb(const std::string& display, const std::string& view) const {
    const Impl::DisplayView target = impl_->resolve(display, view);
    std::string space = impl_->config->getDisplayViewColorSpaceName(target.display.c_str(), target.view.c_str());
    if (space == OCIO::OCIO_VIEW_USE_DISPLAY_NAME) space = target.display;
    const OCIO::ConstColorSpaceRcPtr output = impl_->config->getColorSpace(space.c_str());
    return output && !output->isData() && lower(target.display).find("srgb") != std::string::npos;
}

void ColorConfig::apply(std::span<float> rgb, const std::string& display, const std::string& view) const {
    if (rgb.size() % 3 != 0) {
        throw SettingsError("a display transform takes rgb triples, not " + std::to_string(rgb.size()) + " values");
    }
    const OCIO::ConstCPUProcessorRcPtr processor = impl_->processor(impl_->resolve(display, view));
    if (rgb.empty()) return;
    OCIO::PackedImageDesc pixels(rgb.data(), static_cast<long>(rgb.size() / 3), 1, 3);
    processor->apply(pixels);
}

}  // namespace etendue
