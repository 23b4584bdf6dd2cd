#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <etendue/export.h>
#include <etendue/render_settings.h>

namespace etendue {

/// Name of an AOV as it appears in files and in Python: "color", "alpha", "depth", "normal", "albedo",
/// "sample_count", "variance".
[[nodiscard]] ETENDUE_EXPORT std::string_view aov_name(Aov aov);

/// 3 for color, normal, albedo and variance, else 1.
[[nodiscard]] ETENDUE_EXPORT int aov_channels(Aov aov);

/// One AOV: `channels` floats a pixel, row 0 on top, scene-linear. Color is radiance in nits times the camera's
/// exposure scale, linear Rec.709; infinite where a float cannot hold it. Alpha is the share of samples that met a
/// surface. Normal (world space, that of shading with normal maps, not normalised) and depth are means over the samples
/// that met one, albedo over all samples. An unfinished pass counts in all but the variance. Depth is the distance
/// along the viewing axis in scene units, infinite where nothing is hit. Variance is that of the pixel's mean, from up
/// to eight independent parts of the render; infinite while fewer than two passes are complete.
struct AovImage {
    Aov aov = Aov::Color;
    int channels = 0;
    std::vector<float> data;
};

/// What one strategy alone made of the picture; three floats a pixel, row 0 on top. Weighted, its share of the color:
/// with all path lengths shown, shares sum up to it. Unweighted, its own estimate C*_{s,t} of theory.md §2, of all
/// light that takes s + t - 1 edges and that it can sample.
struct StrategyImage {
    Strategy strategy;
    bool weighted = true;
    std::vector<float> data;
};

/// "st.weighted.s2t3", "st.unweighted.s2t3": the layer's name in files and in Python.
[[nodiscard]] ETENDUE_EXPORT std::string strategy_image_name(const StrategyImage& image);

/// Why a contribution could not be added to the film. Each is counted, none is added.
enum class InvalidKind { NotANumber, Infinite, Negative };
inline constexpr int kInvalidKinds = 3;

/// Where relative errors stop being relative: a pixel darker than this part of the picture's mean counts about as that
/// bright. Black would divide by zero otherwise.
inline constexpr double kDarkestPart = 0.02;

struct RenderStatistics {
    std::int64_t passes = 0;  ///< complete passes
    double seconds = 0;
    /// How far the picture is from what it converges to, relatively; infinite while unknown. It is sqrt(relMSE), where
    /// relMSE is the mean over pixels of
    ///
    ///     (e_r^2 + e_g^2 + e_b^2) / 3 / (m^2 + (kDarkestPart M)^2)
    ///
    /// with e the pixel's error in each channel, m the mean of its true channels, and M that of the whole picture.
    /// Channels count alike: noise in blue is noise. Estimated from the replicates that the variance AOV is made of, as
    /// last looked at: passes since grew by less than a factor of two, none once the render has ended. Known, if there
    /// is an error target or that AOV, or if samples are placed adaptively, once a render of 8 complete passes or more
    /// has ended, and while it runs from the first look on, at 16. It is noise that is estimated, without what a finite
    /// depth leaves out, and only noise that has been seen: an event too rare for any pass so far is not in it.
    double error = std::numeric_limits<double>::infinity();
    std::optional<ChosenMethod> chosen;  ///< by IntegratorKind::Auto; empty until it has, and for others
    std::uint64_t camera_paths = 0;
    std::uint64_t light_paths = 0;
    std::uint64_t rays = 0;                              ///< intersection and visibility rays
    std::array<std::uint64_t, kInvalidKinds> invalid{};  ///< by InvalidKind
};

/// A copy of the film: what had been rendered when the snapshot was taken.
struct RenderedImage {
    int width = 0;  ///< of the window
    int height = 0;
    PixelWindow window;  ///< within the full image
    int full_width = 0;
    int full_height = 0;
    std::vector<AovImage> aovs;
    std::vector<StrategyImage> strategy_images;  ///< by path length, then s; weighted before unweighted
    RenderStatistics statistics;

    /// The AOV, or null when it was not asked for.
    [[nodiscard]] const AovImage* find(Aov aov) const {
        for (const AovImage& image : aovs) {
            if (image.aov == aov) return &image;
        }
        return nullptr;
    }
};

}  // namespace etendue
