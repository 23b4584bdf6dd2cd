#include "session/validate_settings.h"

#include <cmath>
#include <string>

#include <etendue/error.h>

namespace etendue {
namespace {

/// Keeps the numbers of a pass's light paths, counted over the largest images, within 64 bits.
constexpr double kMostLightPathsPerPixel = 1e6;
constexpr int kMostBounces = 1'000'000;
constexpr int kLongestStrategyImages = 30;  // edges: a thousand images
constexpr double kLargestFilter = 1000;     // pixels

void require(bool holds, const char* message) {
    if (!holds) throw SettingsError(message);
}

void validate_camera(const RenderSettings& settings, const SceneDescription& scene) {
    const std::string prefix = scene.source.empty() ? "" : scene.source + ": ";
    if (scene.cameras.empty()) throw SceneError(prefix + "the scene has no camera");
    if (settings.camera < 0 || settings.camera >= static_cast<int>(scene.cameras.size())) {
        throw SettingsError(prefix + "camera index " + std::to_string(settings.camera) + " is out of range");
    }
}

void validate_window(const RenderSettings& settings) {
    require(settings.width > 0 && settings.height > 0, "the image must be at least one pixel wide and high");
    const PixelWindow w = render_window(settings);
    require(w.x0 >= 0 && w.y0 >= 0 && w.x1 <= settings.width && w.y1 <= settings.height,
            "the crop reaches beyond the image");
    require(w.x0 < w.x1 && w.y0 < w.y1, "the crop is empty");
}

}  // namespace

void validate_settings(const RenderSettings& settings, const SceneDescription& scene) {
    validate_camera(settings, scene);
    validate_window(settings);
    require(settings.samples_per_pixel >= 0, "samples per pixel must not be negative");
    require(settings.time_limit >= 0 && std::isfinite(settings.time_limit), "the time limit must not be negative");
    require(settings.error_target >= 0 && std::isfinite(settings.error_target),
            "the error target must not be negative");
    require(settings.samples_per_pixel > 0 || settings.time_limit > 0 || settings.error_target > 0,
            "a render needs a number of samples per pixel, a time limit or an error target");
    require(settings.max_depth >= 0, "the maximum depth must not be negative");
    require(settings.max_depth <= kMostBounces, "the maximum depth is too large");
    require(settings.filter.radius <= kLargestFilter, "the filter radius is too large");
    const double light_paths = settings.light_paths_per_pixel.value_or(1);
    require(settings.integrator == IntegratorKind::Path || light_paths > 0 || settings.strategies.emission_hit ||
                settings.strategies.direct_light,
            "without light paths only the strategies of the camera remain, and they are switched off");
    require(settings.integrator != IntegratorKind::Light || light_paths > 0, "the light integrator needs light paths");
    const StrategySet& s = settings.strategies;
    require(
        settings.integrator != IntegratorKind::Auto || (s.emission_hit && s.direct_light && s.connection &&
                                                        s.light_image && s.lens_hit && !settings.light_paths_per_pixel),
        "the auto integrator chooses strategies and light paths itself");
    require(settings.texture_memory > 0 && std::isfinite(settings.texture_memory),
            "the texture memory must be positive");
    require(settings.threads >= 0, "the number of threads must not be negative");
    require(light_paths >= 0 && std::isfinite(light_paths), "light paths per pixel must not be negative");
    require(light_paths <= kMostLightPathsPerPixel, "too many light paths per pixel");
    require(!settings.single_strategy || settings.integrator == IntegratorKind::Bdpt,
            "a single strategy needs the bdpt integrator");
    require(settings.strategy_images >= 0, "the path length of strategy images must not be negative");
    require(settings.strategy_images <= kLongestStrategyImages, "strategy images of such long paths are too many");
    require(settings.strategy_images == 0 || settings.integrator == IntegratorKind::Bdpt ||
                settings.integrator == IntegratorKind::Light,
            "strategy images need the bdpt or the light integrator");
    require(settings.strategy_images == 0 || !settings.single_strategy,
            "strategy images show all strategies, not a single one");
    const Strategy strategy = settings.single_strategy.value_or(Strategy{1, 1});
    require(strategy.s >= 0 && strategy.t >= 0 && strategy.s + strategy.t >= 2,
            "a single strategy needs at least two vertices");
}

PixelWindow render_window(const RenderSettings& settings) {
    return settings.crop.value_or(PixelWindow{0, 0, settings.width, settings.height});
}

}  // namespace etendue
