// Renders whose samples go where the noise is (RenderSettings::adaptive).

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include <etendue/render_session.h>

#include "support/replicas.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

/// Several tiles, some narrow; a filter that reaches over their edges; light paths that do not share out evenly.
RenderSettings adaptive_settings(IntegratorKind integrator) {
    RenderSettings settings = small_settings(integrator, 48, 29);
    settings.crop = {3, 2, 41, 37};
    settings.filter = {FilterKind::Gaussian, 1.5};
    settings.light_paths_per_pixel = 0.7;
    settings.max_depth = 3;
    settings.adaptive = true;
    return settings;
}

const std::vector<float>& color(const RenderedImage& image) { return image.find(Aov::Color)->data; }

class Adaptive : public testing::TestWithParam<IntegratorKind> {};

TEST_P(Adaptive, PlacesSamplesAndCountsThem) {
    RenderSettings settings = adaptive_settings(GetParam());
    settings.aovs.push_back(Aov::SampleCount);
    const RenderedImage image = render(orthographic_sky(), settings);
    const std::vector<float>& counts = image.find(Aov::SampleCount)->data;
    const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
    EXPECT_GT(*most, 1.5F * *least);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0.0), static_cast<double>(image.statistics.camera_paths));
    EXPECT_EQ(image.statistics.passes, 29);
    EXPECT_LT(image.statistics.error, 1);  // known, though nobody asked
}

TEST_P(Adaptive, ShowsTheSamePicture) {
    RenderSettings settings = adaptive_settings(GetParam());
    settings.samples_per_pixel = 24;
    constexpr int count = 16;
    const Replicas with = render_replicas(orthographic_sky(), settings, count, 1);
    settings.adaptive = false;
    EXPECT_TRUE(same_picture(with, render_replicas(orthographic_sky(), settings, count, 2), 0.02));
}

TEST_P(Adaptive, DoesNotDependOnThreads) {
    RenderSettings settings = adaptive_settings(GetParam());
    settings.aovs = {Aov::Color, Aov::Alpha, Aov::Depth, Aov::Normal, Aov::Albedo, Aov::SampleCount, Aov::Variance};
    settings.threads = 1;
    const RenderedImage expected = render(orthographic_sky(), settings);
    for (int threads : {2, 5}) {
        settings.threads = threads;
        const RenderedImage image = render(orthographic_sky(), settings);
        for (std::size_t i = 0; i < image.aovs.size(); ++i) EXPECT_EQ(image.aovs[i].data, expected.aovs[i].data) << i;
        EXPECT_EQ(image.statistics.rays, expected.statistics.rays);
    }
}

// Until the 17th pass there is nothing to know.
TEST_P(Adaptive, BeginsAsAnyRender) {
    RenderSettings settings = adaptive_settings(GetParam());
    settings.samples_per_pixel = 16;
    settings.aovs = {Aov::Color, Aov::Alpha, Aov::Depth, Aov::Normal, Aov::Albedo, Aov::SampleCount};
    const RenderedImage with = render(orthographic_sky(), settings);
    settings.adaptive = false;
    const RenderedImage without = render(orthographic_sky(), settings);
    for (std::size_t i = 0; i < with.aovs.size(); ++i) {
        for (std::size_t k = 0; k < with.aovs[i].data.size(); ++k) {
            ASSERT_FLOAT_EQ(with.aovs[i].data[k], without.aovs[i].data[k]) << i;
        }
    }
}

// Surfaces are where they are, however often one looks.
TEST_P(Adaptive, SeesTheSameSurfaces) {
    RenderSettings settings = adaptive_settings(GetParam());
    settings.samples_per_pixel = 64;
    settings.filter = {FilterKind::Box, 1e-3};  // all samples of a pixel in one point
    settings.aovs = {Aov::Alpha, Aov::Depth, Aov::Normal, Aov::Albedo};
    const RenderedImage with = render(diffuse_box(), settings);
    settings.adaptive = false;
    const RenderedImage without = render(diffuse_box(), settings);
    for (std::size_t i = 0; i < with.aovs.size(); ++i) {
        std::size_t off = 0;
        for (std::size_t k = 0; k < with.aovs[i].data.size(); ++k) {
            const float a = with.aovs[i].data[k];
            const float b = without.aovs[i].data[k];
            if (a != b && !(std::abs(a - b) <= 0.01F * (std::abs(b) + 0.1F))) ++off;
        }
        EXPECT_LT(off, with.aovs[i].data.size() / 100) << i;  // edges run through points
    }
}

TEST_P(Adaptive, CombinesWithOtherLimits) {
    RenderSettings settings = adaptive_settings(GetParam());
    settings.samples_per_pixel = 0;
    settings.error_target = 0.1;
    const RenderStatistics enough = render(diffuse_box(), settings).statistics;
    EXPECT_LT(enough.error, 0.1);
    EXPECT_GT(enough.passes, 16);
    settings.error_target = 1e-6;
    settings.time_limit = 0.3;
    const RenderedImage brief = render(diffuse_box(), settings);
    EXPECT_GE(brief.statistics.seconds, 0.3);
    EXPECT_GT(*std::max_element(color(brief).begin(), color(brief).end()), 0);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Adaptive, testing::Values(IntegratorKind::Path, IntegratorKind::Bdpt));

TEST(AdaptiveRender, IsNothingToTheLightIntegrator) {
    RenderSettings settings = adaptive_settings(IntegratorKind::Light);
    const RenderedImage with = render(orthographic_sky(), settings);
    settings.adaptive = false;
    EXPECT_EQ(color(with), color(render(orthographic_sky(), settings)));
}

TEST(AdaptiveRender, StrategyImagesStillSumUpToThePicture) {
    RenderSettings settings = adaptive_settings(IntegratorKind::Bdpt);
    settings.strategy_images = settings.max_depth + 1;
    const RenderedImage image = render(orthographic_sky(), settings);
    std::vector<double> sums(color(image).size());
    for (const StrategyImage& strategy : image.strategy_images) {
        for (std::size_t i = 0; i < sums.size() && strategy.weighted; ++i) sums[i] += double{strategy.data[i]};
    }
    for (std::size_t i = 0; i < sums.size(); ++i) ASSERT_NEAR(sums[i], color(image)[i], 1e-6 * color(image)[i]) << i;
}

// C*_{s,t} of one strategy is what it shows alone: here direct light, which has all of it.
TEST(AdaptiveRender, UnweightedStrategyImagesAreThePictureTheyAloneMake) {
    RenderSettings settings = adaptive_settings(IntegratorKind::Bdpt);
    settings.max_depth = 1;
    settings.strategies = {.emission_hit = false, .connection = false, .light_image = false, .lens_hit = false};
    settings.strategy_images = 2;
    const RenderedImage image = render(orthographic_sky(), settings);
    ASSERT_EQ(image.strategy_images.size(), 2U);
    for (const StrategyImage& strategy : image.strategy_images) {
        for (std::size_t i = 0; i < strategy.data.size(); ++i) {
            ASSERT_NEAR(strategy.data[i], color(image)[i], 1e-6F * color(image)[i]) << i;
        }
    }
}

}  // namespace
}  // namespace etendue::test
