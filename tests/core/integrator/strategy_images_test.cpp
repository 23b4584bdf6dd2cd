// Images of single strategies (RenderSettings::strategy_images): weighted they are shares of the picture, unweighted
// what the strategy shows when it is rendered alone, whatever part of the image, filter and number of light paths.

#include <cmath>
#include <limits>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include <etendue/render_session.h>

#include "support/replicas.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

/// More than one tile, a filter that reaches across the crop's edge, light paths that do not share out evenly.
RenderSettings awkward_settings(IntegratorKind integrator) {
    RenderSettings settings = small_settings(integrator, 40, 3);
    settings.crop = {3, 5, 28, 25};
    settings.filter = {FilterKind::Gaussian, 2.2};
    settings.light_paths_per_pixel = 0.7;
    settings.max_depth = 3;
    settings.strategy_images = settings.max_depth + 1;
    return settings;
}

std::map<std::string, std::vector<float>> by_name(const RenderedImage& image) {
    std::map<std::string, std::vector<float>> images;
    for (const StrategyImage& strategy : image.strategy_images) images[strategy_image_name(strategy)] = strategy.data;
    EXPECT_EQ(images.size(), image.strategy_images.size());
    return images;
}

/// Every image was rounded to float once.
void expect_shares_of_the_picture(const RenderedImage& image) {
    const std::vector<float>& color = image.find(Aov::Color)->data;
    std::vector<double> sums(color.size());
    for (const StrategyImage& strategy : image.strategy_images) {
        ASSERT_EQ(strategy.data.size(), color.size());
        for (std::size_t i = 0; i < sums.size() && strategy.weighted; ++i) sums[i] += double{strategy.data[i]};
    }
    double lit = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        ASSERT_NEAR(sums[i], color[i], 2 * std::numeric_limits<float>::epsilon() * color[i]) << i;
        lit += sums[i];
    }
    EXPECT_GT(lit, 0);
}

TEST(StrategyImages, WeightedOnesSumUpToThePicture) {
    for (IntegratorKind integrator : {IntegratorKind::Bdpt, IntegratorKind::Light}) {
        const RenderSettings settings = awkward_settings(integrator);
        expect_shares_of_the_picture(render(lens_box(), settings));
        expect_shares_of_the_picture(render(many_lights(), settings));
        expect_shares_of_the_picture(render(sky(), settings));
    }
}

TEST(StrategyImages, OfARenderThatWasStoppedSumUpToWhatThereIs) {
    RenderSettings settings = awkward_settings(IntegratorKind::Bdpt);
    settings.crop.reset();
    settings.samples_per_pixel = 0;
    settings.time_limit = 1e-9;  // the first tile is the last but for those already begun
    settings.threads = 1;
    const RenderedImage image = render(lens_box(), settings);
    EXPECT_EQ(image.statistics.passes, 0);
    EXPECT_LT(image.statistics.camera_paths, 40U * 40U);
    expect_shares_of_the_picture(image);
}

// C*_{s,t}; that each of these is right by itself is what strategy_test shows.
TEST(StrategyImages, UnweightedOnesAreTheStrategiesAlone) {
    RenderSettings settings = awkward_settings(IntegratorKind::Bdpt);
    settings.max_depth = 2;
    for (const SceneDescription& scene : {lens_box(), sky()}) {
        settings.strategy_images = 3;
        settings.single_strategy.reset();
        const RenderedImage image = render(scene, settings);
        settings.strategy_images = 0;
        for (const StrategyImage& strategy : image.strategy_images) {
            if (strategy.weighted) continue;
            SCOPED_TRACE(strategy_image_name(strategy));
            settings.single_strategy = strategy.strategy;
            const std::vector<float> alone = render(scene, settings).find(Aov::Color)->data;
            for (std::size_t i = 0; i < alone.size(); ++i) ASSERT_FLOAT_EQ(strategy.data[i], alone[i]) << i;
        }
    }
}

TEST(StrategyImages, AreThoseThatTheSceneAndTheSettingsAllow) {
    RenderSettings settings = small_settings(IntegratorKind::Bdpt, 8, 1);
    settings.strategy_images = 2;
    using Names = std::vector<std::string>;
    const auto names = [&](const SceneDescription& scene) {
        Names found;
        for (const auto& [name, data] : by_name(render(scene, settings))) found.push_back(name);
        return found;
    };
    EXPECT_EQ(
        names(lens_box()),
        (Names{"st.unweighted.s0t2", "st.unweighted.s0t3", "st.unweighted.s1t1", "st.unweighted.s1t2",
               "st.unweighted.s2t0", "st.unweighted.s2t1", "st.unweighted.s3t0", "st.weighted.s0t2", "st.weighted.s0t3",
               "st.weighted.s1t1", "st.weighted.s1t2", "st.weighted.s2t0", "st.weighted.s2t1", "st.weighted.s3t0"}));
    settings.max_depth = 0;
    EXPECT_EQ(names(diffuse_box()),
              (Names{"st.unweighted.s0t2", "st.unweighted.s1t1", "st.weighted.s0t2", "st.weighted.s1t1"}));
    settings.integrator = IntegratorKind::Light;
    EXPECT_EQ(names(diffuse_box()), (Names{"st.unweighted.s1t1", "st.weighted.s1t1"}));
    settings.strategy_images = 0;
    EXPECT_EQ(names(diffuse_box()), Names{});
}

TEST(StrategyImages, ChangeNothingInThePicture) {
    RenderSettings settings = awkward_settings(IntegratorKind::Bdpt);
    const RenderedImage with = render(lens_box(), settings);
    settings.threads = 1;
    const auto expected = by_name(render(lens_box(), settings));
    EXPECT_EQ(by_name(with), expected);
    settings.strategy_images = 0;
    EXPECT_EQ(render(lens_box(), settings).find(Aov::Color)->data, with.find(Aov::Color)->data);
}

}  // namespace
}  // namespace etendue::test
