#include "light_params.h"

#include <algorithm>
#include <array>
#include <string>

#include <pxr/usd/sdf/assetPath.h>
#include <pxr/usd/usdLux/blackbody.h>

#include "convert.h"
#include "texture_files.h"

namespace etendue::hydra {
namespace {

/// A parameter that means nothing to light, and the value at which it does nothing.
struct NonPhysical {
    const char* name;
    double neutral;
};
constexpr std::array kNonPhysical{NonPhysical{"diffuse", 1}, NonPhysical{"specular", 1}};
constexpr std::array kShaping{"shaping:focus", "shaping:focusTint", "shaping:cone:angle", "shaping:cone:softness"};

std::string asset_name(const VtValue& asset) {
    if (asset.IsHolding<std::string>()) return asset.UncheckedGet<std::string>();
    return asset.IsHolding<SdfAssetPath>() ? asset.UncheckedGet<SdfAssetPath>().GetAssetPath() : std::string();
}

bool names_file(const VtValue& asset) { return !asset_name(asset).empty(); }

}  // namespace

VtValue LightParams::value(const char* name) const { return delegate_.GetLightParamValue(path_, TfToken(name)); }

double LightParams::number(const char* name, double fallback) const { return number_or(value(name), fallback); }

void LightParams::warn(const std::string& kind, const std::string& message) const {
    warnings_.warn("light " + kind, path_, message);
}

void LightParams::fill_emission(LightDesc& desc) const {
    desc.intensity = number("intensity", desc.intensity);
    desc.exposure = number("exposure", desc.exposure);
    desc.color = color_or(value("color"), desc.color);
    desc.normalize = number("normalize", 0) != 0;
    if (number("enableColorTemperature", 0) != 0) {
        const GfVec3f rgb = UsdLuxBlackbodyTemperatureAsRgb(static_cast<float>(number("colorTemperature", 6500)));
        desc.color_temperature_rgb = {rgb[0], rgb[1], rgb[2]};
    }
    fill_shaping(desc);
}

void LightParams::fill_size(LightDesc& desc) const {
    desc.width = number("width", desc.width);
    desc.height = number("height", desc.height);
    desc.length = number("length", desc.length);
    desc.radius = number("radius", desc.radius);
    desc.angle = number("angle", desc.angle);
    desc.treat_as_point = desc.kind == LightKind::Sphere && number("treatAsPoint", 0) != 0;
    desc.treat_as_line = desc.kind == LightKind::Cylinder && number("treatAsLine", 0) != 0;
    if (desc.kind == LightKind::Rect || desc.kind == LightKind::Dome) fill_texture(desc);
}

void LightParams::fill_texture(LightDesc& desc) const {
    const VtValue asset = value("texture:file");
    if (!names_file(asset)) return;
    const std::string layout = text(value("texture:format"));
    if (desc.kind == LightKind::Dome && !layout.empty() && layout != "automatic" && layout != "latlong") {
        warn("texture format " + layout,
             "texture:format '" + layout + "' is not supported, only latlong; the constant colour is used");
        return;
    }
    if (asset_name(asset).find("<UDIM>") != std::string::npos) {
        warn("udim", "a light's texture cannot be a UDIM set; the constant colour is used");
        return;
    }
    desc.texture_file = texture_file(warnings_, path_, asset, "the constant colour").value_or("");
}

/// Hydra does not say whether ShapingAPI is applied, but a light without it has none of its parameters.
void LightParams::fill_shaping(LightDesc& desc) const {
    if (names_file(value("shaping:ies:file"))) warn("ies", "IES profiles are not supported; the light does without");
    const auto is_set = [this](const char* name) { return !value(name).IsEmpty(); };
    if (!std::any_of(kShaping.begin(), kShaping.end(), is_set)) return;
    if (desc.kind == LightKind::Dome || desc.kind == LightKind::Distant) {
        warn("shaping", "shaping is not supported on distant and dome lights; it is ignored");
        return;
    }
    ShapingDesc shaping;
    shaping.focus = number("shaping:focus", shaping.focus);
    shaping.focus_tint = color_or(value("shaping:focusTint"), shaping.focus_tint);
    shaping.cone_angle = number("shaping:cone:angle", shaping.cone_angle);
    shaping.cone_softness = number("shaping:cone:softness", shaping.cone_softness);
    desc.shaping = shaping;
}

void LightParams::warn_unsupported() const {
    for (const NonPhysical& parameter : kNonPhysical) {
        if (number(parameter.name, parameter.neutral) != parameter.neutral) {
            warn(parameter.name,
                 "inputs:" + std::string(parameter.name) + " is not physical and not supported; 1 is used");
        }
    }
    const VtValue filters = value("filters");
    if (filters.IsHolding<SdfPathVector>() && !filters.UncheckedGet<SdfPathVector>().empty()) {
        warn("filters", "light filters are not supported; the unfiltered light is used");
    }
    const VtValue portals = value("portals");
    if (portals.IsHolding<SdfPathVector>() && !portals.UncheckedGet<SdfPathVector>().empty()) {
        warn("portals", "portals are not supported; the whole dome is sampled");
    }
    if (number("shadow:enable", 1) == 0) warn("shadow", "lights without shadows are not supported; it casts them");
    for (const char* const link : {"lightLink", "shadowLink"}) {
        if (!text(value(link)).empty()) {
            warn(std::string("linking ") + link, std::string(link) + " is not supported; the light reaches everything");
        }
    }
}

std::optional<MeshLight> read_mesh_light(HdSceneDelegate& delegate, Warnings& warnings, const SdfPath& path) {
    const LightParams params(delegate, warnings, path);
    if (params.number("isLight", 0) == 0) return std::nullopt;
    MeshLight light;
    light.desc.kind = LightKind::Mesh;
    light.desc.name = path.GetString();
    params.fill_emission(light.desc);
    params.warn_unsupported();
    const std::string sync = text(params.value("materialSyncMode"));
    if (sync == "noMaterialResponse") light.sync = MaterialSync::NoResponse;
    if (sync == "independent") light.sync = MaterialSync::Independent;
    light.desc.tinted_by_material = light.sync == MaterialSync::GlowTintsLight;
    return light;
}

}  // namespace etendue::hydra
