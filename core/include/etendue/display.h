#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <etendue/export.h>

namespace etendue {

/// An OpenColorIO configuration: the file given, else $OCIO, else Etendue's own (profile 2.1), which has the displays
/// "sRGB" (the default), "Rec.1886", "Display P3" and "P3-D65", each with the views "ACES 1.0 SDR" (the default: the
/// filmic curve that look development expects), "Un-tone-mapped" (encoding only) and "Raw". Names are matched whatever
/// their case. Const members may be called from several threads.
class ETENDUE_EXPORT ColorConfig {
public:
    /// `file` empty: $OCIO if set, else the built-in configuration. Throws FileError naming the file.
    explicit ColorConfig(const std::string& file = {});
    ~ColorConfig();
    ColorConfig(ColorConfig&&) noexcept;
    ColorConfig& operator=(ColorConfig&&) noexcept;

    [[nodiscard]] const std::string& source() const;  ///< file name, or "built-in"
    [[nodiscard]] std::vector<std::string> displays() const;
    [[nodiscard]] std::vector<std::string> views(const std::string& display) const;
    [[nodiscard]] std::string default_display() const;
    [[nodiscard]] std::string default_view(const std::string& display) const;

    /// Whether that view's values are to be shown as sRGB, which is what image files are then tagged with.
    [[nodiscard]] bool encodes_srgb(const std::string& display = {}, const std::string& view = {}) const;

    /// Turns scene-linear Rec.709 rgb triples into display values, in place; 1 is the display's white, nothing is
    /// clipped. Empty names: the defaults. Throws SettingsError that lists what exists when the display or the view is
    /// unknown, FileError when the configuration cannot do it (a LUT is missing, or it knows neither linear Rec.709 nor
    /// an interchange space).
    void apply(std::span<float> rgb, const std::string& display = {}, const std::string& view = {}) const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace etendue
