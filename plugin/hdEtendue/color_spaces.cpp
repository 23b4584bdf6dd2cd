#include "color_spaces.h"

#include <map>
#include <set>

#include <pxr/base/gf/color.h>
#include <pxr/base/gf/colorSpace.h>
#include <pxr/base/gf/vec3f.h>

namespace etendue::hydra {
namespace {

const char* const kRenderingSpace = "lin_rec709_scene";

/// MaterialX and older USD files name the same spaces differently.
std::string canonical(const std::string& space) {
    static const std::map<std::string, std::string> aliases{{"lin_rec709", kRenderingSpace},
                                                            {"lin_srgb", kRenderingSpace},
                                                            {"linear", kRenderingSpace},
                                                            {"sRGB", "srgb_rec709_scene"},
                                                            {"srgb_texture", "srgb_rec709_scene"},
                                                            {"acescg", "lin_ap1_scene"},
                                                            {"lin_ap1", "lin_ap1_scene"},
                                                            {"lin_ap0", "lin_ap0_scene"},
                                                            {"lin_rec2020", "lin_rec2020_scene"},
                                                            {"lin_displayp3", "lin_p3d65_scene"},
                                                            {"srgb_displayp3", "srgb_p3d65_scene"},
                                                            {"lin_adobergb", "lin_adobergb_scene"},
                                                            {"g18_rec709", "g18_rec709_scene"},
                                                            {"g22_rec709", "g22_rec709_scene"},
                                                            {"g22_ap1", "g22_ap1_scene"},
                                                            {"adobergb", "g22_adobergb_scene"}};
    const auto alias = aliases.find(space);
    return alias == aliases.end() ? space : alias->second;
}

/// Spaces in which numbers are taken as they stand.
bool is_linear_or_data(const std::string& space) {
    static const std::set<std::string> names{"", "data", "raw", "Raw", "identity", "auto", kRenderingSpace};
    return names.contains(space);
}

}  // namespace

Color to_rendering_space(Warnings& warnings, const SdfPath& path, const std::string& space, const Color& rgb) {
    const std::string name = canonical(space);
    if (is_linear_or_data(name)) return rgb;
    if (!GfColorSpace::IsValid(TfToken(name))) {
        warnings.warn("color space " + name, path,
                      "unknown colour space '" + name + "'; the colour is taken as linear Rec.709");
        return rgb;
    }
    const GfVec3f source(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]));
    const GfVec3f out = GfColorSpace(TfToken(kRenderingSpace)).Convert(GfColorSpace(TfToken(name)), source).GetRGB();
    return {out[0], out[1], out[2]};
}

TextureColorSpace file_color_space(Warnings& warnings, const SdfPath& path, const std::string& space) {
    const std::string name = canonical(space);
    if (name == "srgb_rec709_scene") return TextureColorSpace::Srgb;
    if (name.empty() || name == "auto") return TextureColorSpace::Auto;
    if (is_linear_or_data(name)) return TextureColorSpace::Raw;
    warnings.warn("texture color space " + name, path,
                  "texture colour space '" + name + "' is not supported; 'auto' is used");
    return TextureColorSpace::Auto;
}

}  // namespace etendue::hydra
