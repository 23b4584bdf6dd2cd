#include "session/pilot.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

#include "film/film.h"
#include "film/replicates.h"
#include "integrator/integrator.h"
#include "scene/media_probe.h"
#include "session/pass.h"
#include "session/rare_light.h"
#include "session/sample_plan.h"
#include "session/validate_settings.h"

namespace etendue {
namespace {

// ------------------------------------------------------------------------------------------------------ how much

/// Noise of a pixel does not depend on how many there are of them: so many tell a picture's.
constexpr double kPixels = 768;
/// Of one trial, in rays; a million are a third of a second of one core. Trials of expensive methods take more, because
/// each replicate has a pass at least.
constexpr double kWork = 150e3;
/// Bdpt's bookkeeping for a path takes about as long as a ray: measured on the stages.
constexpr double kWorkOfPath = 1;
/// Renders of fewer samples go without: all trials together take 0.2 to 1 second of one core, this many samples 2
/// to 30.
constexpr double kLeastSamples = 2e6;
constexpr double kLeastSeconds = 5;

/// Of one core. A render that ends by the clock within its first passes has seen some of its pixels less than others,
/// or not at all.
constexpr double kWorkPerSecond = 3e6;
constexpr double kLeastPasses = 2;

/// Of the pixels, those with the greatest errors; a firefly that one method happens to meet would else decide.
constexpr double kLeftOut = 0.01;
constexpr int kLongestRare = 16;  ///< edges, of the paths that RareLight looks at

double pixels(const PixelWindow& window) {
    return static_cast<double>(window.x1 - window.x0) * (window.y1 - window.y0);
}

PixelWindow scaled(const PixelWindow& window, double scale, int width, int height) {
    const auto down = [&](int at, int limit) { return std::min(static_cast<int>(at * scale), limit - 1); };
    const int x0 = down(window.x0, width);
    const int y0 = down(window.y0, height);
    return {x0, y0, std::clamp(static_cast<int>(window.x1 * scale), x0 + 1, width),
            std::clamp(static_cast<int>(window.y1 * scale), y0 + 1, height)};
}

// ------------------------------------------------------------------------------------------------------- figures

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Without that part of the values that is largest.
double trimmed_mean(std::vector<double> values, double left_out) {
    const auto kept = static_cast<std::ptrdiff_t>(std::ceil((1 - left_out) * static_cast<double>(values.size())));
    std::nth_element(values.begin(), values.begin() + (kept - 1), values.end());
    values.resize(static_cast<std::size_t>(kept));
    return mean_of(values);
}

std::vector<double> gray(const AovImage& image, double scale) {
    std::vector<double> out;
    for (std::size_t i = 0; i + 2 < image.data.size(); i += 3) {
        out.push_back((static_cast<double>(image.data[i]) + image.data[i + 1] + image.data[i + 2]) * (scale / 3));
    }
    return out;
}

double work_of_pass(const RenderStatistics& statistics, const ChosenMethod& method) {
    auto work = static_cast<double>(statistics.rays);
    if (method.integrator != IntegratorKind::Path) {
        work += kWorkOfPath * static_cast<double>(statistics.camera_paths + statistics.light_paths);
    }
    return work / static_cast<double>(statistics.passes);
}

bool worth_a_pilot(const RenderSettings& settings) {
    const double least_passes = kLeastSamples / pixels(render_window(settings));
    // One sample per pixel has a relative error of about 1.
    const double passes_to_target = 1 / (settings.error_target * settings.error_target);
    return (settings.samples_per_pixel == 0 || settings.samples_per_pixel >= least_passes) &&
           (settings.time_limit == 0 || settings.time_limit >= kLeastSeconds) && passes_to_target >= least_passes;
}

}  // namespace

RenderSettings pilot_settings(const RenderSettings& settings) {
    RenderSettings small = settings;
    const double scale = std::min(1.0, std::sqrt(kPixels / pixels(render_window(settings))));
    small.width = std::max(1, static_cast<int>(settings.width * scale));
    small.height = std::max(1, static_cast<int>(settings.height * scale));
    if (settings.crop) small.crop = scaled(*settings.crop, scale, small.width, small.height);
    small.seed = ~settings.seed;
    small.aovs = {Aov::Color, Aov::Variance};
    small.error_target = 0;
    small.adaptive = false;
    return small;
}

Pilot::Pilot(const Scene& scene, const Camera& camera, const RenderSettings& settings, const StrategySet& strategies,
             const std::atomic<bool>& stop)
    : scene_(scene), camera_(camera), settings_(settings), strategies_(strategies), stop_(stop) {}

double Pilot::cost(const ChosenMethod& method) {
    const Trial& tried = trial(method);
    double error = relative_error(tried.variance, kLeftOut);
    if (method.integrator == IntegratorKind::Path) error = std::max(error, rare_error());
    return error * tried.work;
}

double Pilot::most_light_paths(double pixels, double work) {
    const auto of_pixel = [this](double n) {
        const Trial& tried = trial({IntegratorKind::Bdpt, n});
        return tried.work / static_cast<double>(tried.mean.size());
    };
    const double of_light_path = (of_pixel(4) - of_pixel(1)) / 3;
    double n = kMostLightPaths;
    while (n > kFewestLightPaths && pixels * (of_pixel(1) + (n - 1) * of_light_path) > work) n /= 2;
    return n;
}

const Pilot::Trial& Pilot::trial(const ChosenMethod& method) {
    const auto known =
        std::find_if(trials_.begin(), trials_.end(), [&](const Trial& other) { return other.method == method; });
    if (known != trials_.end()) return *known;
    return trials_.emplace_back(render(method));
}

Pilot::Trial Pilot::render(const ChosenMethod& method) const {
    const RenderSettings settings = settings_of(method);
    const RenderContext about = context(settings);
    const std::unique_ptr<Integrator> integrator = make_integrator(about);
    const PassRunner runner(*integrator, about.window);
    const SamplePlan even(runner.tiles());
    Film film(settings, about.window);
    double work = 0;
    for (std::uint64_t pass = 0; pass < kReplicates || pass % kReplicates != 0 || work < kWork; ++pass) {
        const bool whole = runner.run(pass, even, stop_, [&](const FilmTile& tile) {
            film.add(tile);
            work += static_cast<double>(tile.rays + tile.camera_paths);
        });
        film.end_pass();
        if (!whole) break;
    }
    const RenderedImage image = film.image();
    Trial out;
    out.method = method;
    out.mean = gray(*image.find(Aov::Color), 1);
    out.variance = gray(*image.find(Aov::Variance), static_cast<double>(image.statistics.passes));
    out.noise = mean_of(out.variance);
    out.work = work_of_pass(image.statistics, method);
    return out;
}

/// By all trials of bdpt, the better the more. What path tracing does not find it does not hide.
std::vector<double> Pilot::brightness() const {
    std::vector<double> sum(trials_.front().mean.size());
    double weights = 0;
    for (const Trial& other : trials_) {
        if (other.method.integrator == IntegratorKind::Path) continue;
        const double weight = 1 / std::max(other.noise, std::numeric_limits<double>::min());
        for (std::size_t pixel = 0; pixel < sum.size(); ++pixel) sum[pixel] += weight * other.mean[pixel];
        weights += weight;
    }
    for (double& value : sum) value /= weights;
    return sum;
}

/// relMSE, as RenderStatistics::error has it, of pixels with that variance.
double Pilot::relative_error(const std::vector<double>& variance, double left_out) const {
    std::vector<double> terms = brightness();
    const double darkest = kDarkestPart * mean_of(terms);
    for (std::size_t pixel = 0; pixel < terms.size(); ++pixel) {
        const double squared = terms[pixel] * terms[pixel] + darkest * darkest;
        terms[pixel] = variance[pixel] > 0 ? variance[pixel] / squared : 0;
    }
    return trimmed_mean(std::move(terms), left_out);
}

/// Of path tracing: what RareLight says.
double Pilot::rare_error() {
    RenderSettings settings = settings_of({IntegratorKind::Bdpt, 1});
    settings.heuristic = MisHeuristic::Power;
    settings.strategy_images = kLongestRare;
    const RenderContext about = context(settings);
    const std::unique_ptr<Integrator> integrator = make_integrator(about);
    RareLight rare(about.window, brightness(), integrator->image_strategies(),
                   static_cast<double>(integrator->light_paths_per_pass()));
    const PassRunner runner(*integrator, about.window);
    const SamplePlan even(runner.tiles());
    for (std::uint64_t pass = 0; pass < kReplicates; ++pass) {
        runner.run(pass, even, stop_, [&](const FilmTile& tile) { rare.add(tile); });
    }
    return relative_error(rare.variance(static_cast<double>(kReplicates)), 0);
}

RenderSettings Pilot::settings_of(const ChosenMethod& method) const {
    RenderSettings settings = settings_;
    settings.integrator = method.integrator;
    settings.light_paths_per_pixel = method.light_paths_per_pixel;
    return settings;
}

RenderContext Pilot::context(const RenderSettings& settings) const {
    return {scene_,
            camera_,
            settings,
            Filter(settings.filter),
            render_window(settings),
            strategies_,
            false,
            false,
            media_at(scene_, camera_.position())};
}

ChosenMethod choose_method(const RenderSettings& settings, const Scene& scene, const Camera& camera,
                           const StrategySet& strategies, const std::atomic<bool>& stop) {
    if (scene.light_count() == 0 || settings.max_depth == 0) return {IntegratorKind::Path, {}};
    if (!worth_a_pilot(settings)) return {};
    Pilot pilot(scene, camera, pilot_settings(settings), strategies, stop);
    const bool path_finds_all = !scene.needs_light_paths();
    const auto cost = [&](const ChosenMethod& method) {
        const bool may = method.integrator != IntegratorKind::Path || path_finds_all;
        return may ? pilot.cost(method) : std::numeric_limits<double>::infinity();
    };
    if (settings.time_limit == 0) return choose_method(cost);
    const double work_of_pass = settings.time_limit * kWorkPerSecond / kLeastPasses;
    return choose_method(cost, pilot.most_light_paths(pixels(render_window(settings)), work_of_pass));
}

}  // namespace etendue
