#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <etendue/scene_description.h>

namespace etendue {

/// Auto chooses Path, or Bdpt with a number of light paths, by what the scene holds and, where the render is long
/// enough to pay for it, by a small trial of each. RenderStatistics::chosen tells which; the same settings choose the
/// same.
enum class IntegratorKind { Path, Light, Bdpt, Auto };

/// Power heuristic has beta = 2 (Veach 9.2), balance beta = 1.
enum class MisHeuristic { Balance, Power };

/// The three adjoint corrections (theory.md §5, §6, §7). Switching one off is wrong on purpose: for validation only.
struct AdjointPolicy {
    bool refraction = true;
    bool shading_normal = true;
    bool phong = true;
};

/// Which bidirectional strategies take part. (s, t): s light vertices, t camera vertices. With a subset the image is
/// complete only if the subset covers every path of the scene.
struct StrategySet {
    bool emission_hit = true;  ///< s = 0: the camera path finds a light
    bool direct_light = true;  ///< s = 1, t >= 2: next-event estimation
    bool connection = true;    ///< s >= 2, t >= 2
    bool light_image = true;   ///< t = 1: a light vertex is joined to the lens
    bool lens_hit = true;      ///< t = 0: a light path finds the lens
};

/// One strategy alone.
struct Strategy {
    int s = 0;
    int t = 0;
};

/// What IntegratorKind::Auto makes of a scene: as settings, they repeat the render.
struct ChosenMethod {
    IntegratorKind integrator = IntegratorKind::Bdpt;  ///< Path, or Bdpt with all its strategies
    std::optional<double> light_paths_per_pixel;       ///< of Bdpt; empty: as RenderSettings has it

    [[nodiscard]] bool operator==(const ChosenMethod&) const = default;
};

enum class Aov { Color, Alpha, Depth, Normal, Albedo, SampleCount, Variance };

enum class FilterKind { Box, Triangle, Gaussian };

/// Reconstruction filter; the radius is in pixels. Box and triangle are separable; the Gaussian is round, has sigma =
/// radius / 3 and ends at the radius.
struct PixelFilter {
    FilterKind kind = FilterKind::Box;
    double radius = 0.5;
};

/// Pixels [x0, x1) x [y0, y1) of the full image, row 0 on top.
struct PixelWindow {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
};

inline constexpr double kDefaultTextureMemory = 1024;  ///< megabytes

struct RenderSettings {
    int camera = 0;  ///< index into SceneDescription::cameras
    int width = 512;
    int height = 512;
    std::optional<PixelWindow> crop;
    ApertureConform conform = ApertureConform::ExpandAperture;

    IntegratorKind integrator = IntegratorKind::Bdpt;
    int samples_per_pixel = 64;  ///< one pass is one sample per pixel; 0: until another limit
    double time_limit = 0;       ///< seconds; 0: none. Whichever limit comes first ends the render
    /// RenderStatistics::error that is good enough; 0: none. It is looked at now and then from the 16th pass on, and
    /// ends the render when it is below the target by twice its own standard error: one that rests on few pixels has to
    /// be smaller. Costs 240 bytes a pixel.
    double error_target = 0;
    /// Camera samples go where they take most off the picture's error: a pass still takes one a pixel in the mean, but
    /// from the 17th on tiles of 16 x 16 pixels have as many as their noise asks for, a quarter of the mean at least.
    /// Unbiased; tests/honesty/README.md has what it gains. Light paths stay as they are, so that it changes nothing
    /// for the light integrator. Costs 350 bytes a pixel, for bdpt 570.
    bool adaptive = false;
    int max_depth = 16;  ///< bounces, s + t - 2; 0 shows emission only
    std::uint64_t seed = 0;
    int threads = 0;  ///< 0: all
    /// Megabytes of texels that are kept decoded; what does not fit is read again when it is needed. An image without
    /// tiles (png, jpeg) is one piece, and each thread holds up to eight pieces whatever the limit.
    double texture_memory = kDefaultTextureMemory;

    PixelFilter filter;
    MisHeuristic heuristic = MisHeuristic::Power;
    StrategySet strategies;                   ///< bdpt; path heeds emission_hit and direct_light
    std::optional<Strategy> single_strategy;  ///< bdpt: shows only this one, unweighted (C* of theory.md §2)
    /// Light subpaths traced per pixel and pass (bdpt, light). Empty: 1 for light; for bdpt 4 where something gathers
    /// light into caustics, which they alone render well, else 0.5. Auto chooses it.
    std::optional<double> light_paths_per_pixel;
    int roulette_depth = 4;  ///< bounces before Russian roulette may end a path; negative: never
    AdjointPolicy adjoint;

    std::vector<Aov> aovs{Aov::Color, Aov::Alpha};
    /// bdpt, light: keeps the image of every strategy, weighted and unweighted, of paths with up to this many edges
    /// (s + t - 1). 0: none. Every strategy costs 72 bytes a pixel.
    int strategy_images = 0;
};

}  // namespace etendue
