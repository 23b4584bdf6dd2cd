#include "settings.h"

#include <array>
#include <cstdlib>
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

constexpr Setting kIntegrator{"etendue:integrator", "Integrator (bdpt, path, light)", "HDETENDUE_INTEGRATOR"};
constexpr Setting kSamples{"etendue:samplesPerPixel", "Samples per pixel", "HDETENDUE_SAMPLES_PER_PIXEL"};
constexpr Setting kTimeLimit{"etendue:timeLimit", "Time limit (seconds, 0: none)", "HDETENDUE_TIME_LIMIT"};
constexpr Setting kMaxDepth{"etendue:maxDepth", "Maximum bounces", "HDETENDUE_MAX_DEPTH"};
constexpr Setting kSeed{"etendue:seed", "Seed", "HDETENDUE_SEED"};
constexpr Setting kThreads{"etendue:threads", "Threads (0: all)", "HDETENDUE_THREADS"};
constexpr Setting kRefraction{"etendue:adjoint:refraction", "Adjoint factor of refraction (off: wrong on purpose)",
                              "HDETENDUE_ADJOINT_REFRACTION"};
constexpr Setting kShadingNormal{"etendue:adjoint:shadingNormal",
                                 "Adjoint factor of shading normals (off: wrong on purpose)",
                                 "HDETENDUE_ADJOINT_SHADING_NORMAL"};
constexpr Setting kPhong{"etendue:adjoint:phong", "Adjoint factor of classic Phong (off: wrong on purpose)",
                         "HDETENDUE_ADJOINT_PHONG"};

constexpr Setting kOutput{"etendue:output", "Write the finished picture to (.exr)", "HDETENDUE_OUTPUT"};

const std::map<std::string, IntegratorKind>& integrators() {
    static const std::map<std::string, IntegratorKind> names{
        {"bdpt", IntegratorKind::Bdpt}, {"path", IntegratorKind::Path}, {"light", IntegratorKind::Light}};
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

/// The host's value as a number, or the fallback after a warning.
double number(const HdRenderDelegate& delegate, const Setting& setting, double fallback) {
    const VtValue value = delegate.GetRenderSetting(TfToken(setting.key));
    if (value.IsEmpty()) return fallback;
    const std::vector<double> all = numbers(value);
    if (!all.empty()) return all.front();
    TF_WARN("Etendue: setting %s is not a number; %g is used", setting.key, fallback);
    return fallback;
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
    return static_cast<int>(number_or(standard, number(delegate, kSamples, fallback)));
}

}  // namespace

HdRenderSettingDescriptorList setting_descriptors() {
    const RenderSettings defaults;
    return {describe(kIntegrator, VtValue(TfGetenv(kIntegrator.variable, "bdpt"))),
            whole(kSamples, defaults.samples_per_pixel),
            describe(kTimeLimit, VtValue(static_cast<float>(TfGetenvDouble(kTimeLimit.variable, 0)))),
            whole(kMaxDepth, defaults.max_depth),
            whole(kSeed, 0),
            whole(kThreads, defaults.threads),
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
    settings.max_depth = static_cast<int>(number(delegate, kMaxDepth, settings.max_depth));
    settings.seed = static_cast<std::uint64_t>(number(delegate, kSeed, 0));
    settings.threads = static_cast<int>(number(delegate, kThreads, settings.threads));
    settings.adjoint.refraction = number(delegate, kRefraction, 1) != 0;
    settings.adjoint.shading_normal = number(delegate, kShadingNormal, 1) != 0;
    settings.adjoint.phong = number(delegate, kPhong, 1) != 0;
    return settings;
}

}  // namespace etendue::hydra
