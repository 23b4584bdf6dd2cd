#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <etendue/film_view.h>
#include <etendue/render_settings.h>
#include <etendue/scene_description.h>

namespace etendue::test {

/// Luminances of independent renders of one picture: what statistical tests of images stand on. Pixels of one render
/// are correlated (they share light paths), renders of different seeds are not.
struct Replicas {
    int width = 0;
    int height = 0;
    std::vector<std::vector<double>> images;  ///< [replica][pixel]
    std::uint64_t invalid = 0;                ///< contributions that were not finite or negative
    std::function<Replicas()> second_look;    ///< as many again, of other seeds and four times the samples

    /// Each replica averaged over blocks of block x block pixels; as large as the image: its mean.
    [[nodiscard]] Replicas blocks(int block) const;
    /// The window's pixels of each replica.
    [[nodiscard]] Replicas cut(const PixelWindow& window) const;
    [[nodiscard]] double mean() const;
    /// Standard error of mean().
    [[nodiscard]] double standard_error() const;
    /// Variance of one replica's pixel, averaged over pixels.
    [[nodiscard]] double mean_pixel_variance() const;
};

/// Renders `count` pictures with seeds of their own; `stream` keeps the seeds of two sets apart.
[[nodiscard]] Replicas render_replicas(const SceneDescription& scene, RenderSettings settings, int count,
                                       std::uint64_t stream);

[[nodiscard]] RenderedImage render(const SceneDescription& scene, const RenderSettings& settings);

/// Small square image, many samples, no depth limit to speak of.
[[nodiscard]] RenderSettings small_settings(IntegratorKind integrator, int size, int samples_per_pixel);

/// Chance that a right renderer fails one call of the tests below.
inline constexpr double kFalseAlarm = 1e-5;

/// Welch t-tests of two sets of renders, pixel by pixel, by 4 x 4 blocks, and as a whole; the smallest p-value is held
/// against kFalseAlarm over the number of tests (Bonferroni: holds for correlated pixels). A t-test is fooled by events
/// so rare that a set may lack them all, so what seems to differ gets a second look: a bias is still there. The
/// standard error of the difference of the two means must be below `resolution` of the mean: pictures that are noise
/// alone agree about nothing.
[[nodiscard]] testing::AssertionResult same_picture(const Replicas& a, const Replicas& b, double resolution = 1);

/// The whole picture's mean against a known value, t-test at kFalseAlarm; its standard error must be below `resolution`
/// of the value, else nothing was shown.
[[nodiscard]] testing::AssertionResult mean_is(const Replicas& a, double expected, double resolution);

}  // namespace etendue::test
