#include "settings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include <pxr/base/tf/diagnostic.h>
#include <pxr/base/tf/getenv.h>
#include <pxr/base/tf/token.h>

#include "convert.h"

namespace etendue::hydra {
namespace {

struct Setting {
    const char* key;
    const char* label;
    const char* variable;  ///< environment variable that holds another default
};

constexpr Setting kIntegrator{"etendue:integrator", "Integrator (bdpt, path, light, auto)", "HDETENDUE_INTEGRATOR"};
constexpr Setting kSamples{"etendue:samplesPerPixel", "Samples per pixel", "HDETENDUE_SAMPLES_PER_PIXEL"};
constexpr Setting kTimeLimit{"etendue:timeLimit", "Time limit (seconds, 0: none)", "HDETENDUE_TIME_LIMIT"};
constexpr Setting kErrorTarget{"etendue:errorTarget", "Relative error that is good enough (0: none)",
                               "HDETENDUE_ERROR_TARGET"};
constexpr Setting kAdaptive{"etendue:adaptive", "Samples go where the noise is", "HDETENDUE_ADAPTIVE"};
constexpr Setting kMaxDepth{"etendue:maxDepth", "Maximum bounces", "HDETENDUE_MAX_DEPTH"};
constexpr Setting kSeed{"etendue:seed", "Seed", "HDETENDUE_SEED"};
constexpr Setting kThreads{"etendue:threads", "Threads (0: all)", "HDETENDUE_THREADS"};
constexpr Setting kTextureMemory{"etendue:textureMemory", "Megabytes of texels kept decoded",
                                 "HDETENDUE_TEXTURE_MEMORY"};
constexpr Setting kRefraction{"etendue:adjoint:refraction", "Adjoint factor of refraction (off: wrong on purpose)",
                              "HDETENDUE_ADJOINT_REFRACTION"};
constexpr Setting kShadingNormal{"etendue:adjoint:shadingNormal",
                                 "Adjoint factor of shading normals (off: wrong on purpose)",
                                 "HDETENDUE_ADJOINT_SHADING_NORMAL"};
constexpr Setting kPhong{"etendue:adjoint:phong", "Adjoint factor of classic Phong (off: wrong on purpose)",
                         "HDETENDUE_ADJOINT_PHONG"};

constexpr Setting kOutput{"etendue:output", "Write the finished picture to (.exr)", "HDETENDUE_OUTPUT"};

const std::map<std::string, IntegratorKind>& integrators() {
    static const std::map<std::string, IntegratorKind> names{{"bdpt", IntegratorKind::Bdpt},
                                                             {"path", IntegratorKind::Path},
                                                             {"light", IntegratorKind::Light},
                                                             {"auto", IntegratorKind::Auto}};
    return names;
}

HdRenderSettingDescriptor describe(const Setting& setting, const VtValue& fallback) {
    return {setting.label, TfToken(setting.key), fallback};
}

HdRenderSettingDescriptor flag(const Setting& setting, bool fallback) {
    return describe(setting, VtValue(TfGetenvBool(setting.variable, fallback)));
}

HdRenderSettingDescriptor whole(const Setting& setting, int fallback) {
    return describe(setting, VtValue(TfGetenvInt(setting.variable, fallback)));
}

HdRenderSettingDescriptor real(const Setting& setting, double fallback) {
    return describe(setting, VtValue(static_cast<float>(TfGetenvDouble(setting.variable, fallback))));
}

/// The host's value as a number, or the fallback after a warning.
double number(const HdRenderDelegate& delegate, const Setting& setting, double fallback) {
    const VtValue value = delegate.GetRenderSetting(TfToken(setting.key));
    if (value.IsEmpty()) return fallback;
    const std::vector<double> all = numbers(value);
    if (!all.empty()) return all.front();
    TF_WARN("Etendue: setting %s is not a number; %g is used", setting.key, fallback);
    return fallback;
}

/// A whole number that a T can hold, or the nearest one.
template <class T>
T whole_number(const HdRenderDelegate& delegate, const Setting& setting, T fallback) {
    const double value = number(delegate, setting, static_cast<double>(fallback));
    // The bounds as doubles may lie just outside of T.
    constexpr double lowest = std::numeric_limits<T>::is_signed ? -1e9 : 0;
    const double held = std::clamp(std::isnan(value) ? static_cast<double>(fallback) : value, lowest, 1e9);
    if (held != value) TF_WARN("Etendue: setting %s is %g; %g is used", setting.key, value, held);
    return static_cast<T>(held);
}

IntegratorKind integrator(const HdRenderDelegate& delegate, IntegratorKind fallback) {
    const std::string name = text(delegate.GetRenderSetting(TfToken(kIntegrator.key)));
    const auto found = integrators().find(name);
    if (found != integrators().end()) return found->second;
    if (!name.empty()) TF_WARN("Etendue: there is no integrator '%s'; bdpt is used", name.c_str());
    return fallback;
}

/// The standard setting of that meaning, where a host sets it, else ours.
int samples_per_pixel(const HdRenderDelegate& delegate, int fallback) {
    const VtValue standard = delegate.GetRenderSetting(HdRenderSettingsTokens->convergedSamplesPerPixel);
    if (standard.IsHolding<int>()) return standard.UncheckedGet<int>();
    return whole_number(delegate, kSamples, fallback);
}

}  // namespace

HdRenderSettingDescriptorList setting_descriptors() {
    const RenderSettings defaults;
    return {describe(kIntegrator, VtValue(TfGetenv(kIntegrator.variable, "bdpt"))),
            whole(kSamples, defaults.samples_per_pixel),
            real(kTimeLimit, defaults.time_limit),
            real(kErrorTarget, defaults.error_target),
            flag(kAdaptive, defaults.adaptive),
            whole(kMaxDepth, defaults.max_depth),
            whole(kSeed, 0),
            whole(kThreads, defaults.threads),
            real(kTextureMemory, defaults.texture_memory),
            flag(kRefraction, defaults.adjoint.refraction),
            flag(kShadingNormal, defaults.adjoint.shading_normal),
            flag(kPhong, defaults.adjoint.phong),
            describe(kOutput, VtValue(TfGetenv(kOutput.variable)))};
}

std::string output_file(const HdRenderDelegate& delegate) {
    return text(delegate.GetRenderSetting(TfToken(kOutput.key)));
}

RenderSettings render_settings(const HdRenderDelegate& delegate) {
    RenderSettings settings;
    settings.integrator = integrator(delegate, settings.integrator);
    settings.samples_per_pixel = samples_per_pixel(delegate, settings.samples_per_pixel);
    settings.time_limit = number(delegate, kTimeLimit, settings.time_limit);
    settings.error_target = number(delegate, kErrorTarget, settings.error_target);
    settings.adaptive = number(delegate, kAdaptive, settings.adaptive ? 1 : 0) != 0;
    settings.max_depth = whole_number(delegate, kMaxDepth, settings.max_depth);
    settings.seed = whole_number(delegate, kSeed, settings.seed);
    settings.threads = whole_number(delegate, kThreads, settings.threads);
    settings.texture_memory = number(delegate, kTextureMemory, settings.texture_memory);
    settings.adjoint.refraction = number(delegate, kRefraction, 1) != 0;
    settings.adjoint.shading_normal = number(delegate, kShadingNormal, 1) != 0;
    settings.adjoint.phong = number(delegate, kPhong, 1) != 0;
    return settings;
}

}  // namespace etendue::hydra
