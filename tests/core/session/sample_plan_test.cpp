// Adaptive pictures are right in the mean, pixel by pixel, and know their error: with made-up samples, of which a few
// thousand pictures cost little.

#include "session/sample_plan.h"

#include <cmath>
#include <functional>
#include <numeric>

#include <gtest/gtest.h>
#include <boost/math/distributions/normal.hpp>

#include "math/rng.h"
#include "session/wanted_samples.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

/// Four tiles of a single row: the fewer pixels decide, the more their luck does.
constexpr int kTiles = 4;
constexpr int kTileWidth = 2;
constexpr int kWidth = kTiles * kTileWidth;

std::vector<PixelWindow> row_of_tiles() {
    std::vector<PixelWindow> tiles;
    for (int i = 0; i < kTiles; ++i) tiles.push_back({i * kTileWidth, 0, (i + 1) * kTileWidth, 1});
    return tiles;
}

/// How often light is met.
double chance_of(int tile) { return 0.8 * std::pow(0.5, tile); }

/// Brightness 1 on average; the more seldom it is met the farther to the right. Only what is lit is a surface.
PixelSample made_up(Rng rng, int tile) {
    const double chance = chance_of(tile);
    const double value = rng.next_1d() < chance ? 1 / chance : 0;
    return {Rgb(value), value > 0, 2, {0, 0, 1}, Rgb(value > 0 ? 0.5 : 0.0)};
}

RenderSettings adaptive_settings() {
    RenderSettings settings;
    settings.width = kWidth;
    settings.height = 1;
    settings.adaptive = true;
    settings.aovs = {Aov::Color, Aov::Alpha, Aov::Depth, Aov::Normal, Aov::Albedo, Aov::SampleCount, Aov::Variance};
    return settings;
}

RenderedImage render(std::uint64_t passes, std::uint64_t seed, SamplePlan plan = SamplePlan(row_of_tiles())) {
    Film film(adaptive_settings(), {0, 0, kWidth, 1});
    for (std::uint64_t pass = 0; pass < passes; ++pass) {
        plan.begin(pass, film);
        for (std::size_t i = 0; i < kTiles; ++i) {
            FilmTile tile;
            tile.reset(row_of_tiles()[i]);
            tile.number = i;
            const SampleRange range = plan.samples(pass, i);
            for (std::uint64_t n = range.first; n < range.first + range.count; ++n) {
                for (std::uint64_t x = 0; x < kTileWidth; ++x) {
                    // Who takes the same number twice has the same sample twice.
                    const std::uint64_t stream = (n * kWidth + i * kTileWidth + x) * kReplicates;
                    tile.samples.push_back(made_up(Rng(seed, stream + place_of_pass(pass).replicate, 1), int(i)));
                    ++tile.rays;
                    ++tile.camera_rays;
                }
            }
            plan.count(pass, tile);
            film.add(tile);
        }
        film.end_pass();
    }
    return film.image();
}

double mean_of(const RenderedImage& image, Aov aov, int tile) {
    const AovImage& a = *image.find(aov);
    double sum = 0;
    for (int x = tile * kTileWidth; x < (tile + 1) * kTileWidth; ++x) {
        sum += double{a.data[static_cast<std::size_t>(x * a.channels)]} / kTileWidth;
    }
    return sum;
}

class SamplePlanAfter : public testing::TestWithParam<std::uint64_t> {};

// Were a half to decide for itself, tile means would be off by the standard errors that are recorded as `z`, times some
// 20. A false alarm in 10^5 seeds, for all of the tests together.
TEST_P(SamplePlanAfter, PicturesAreRightInTheMean) {
    const int pictures = samples(1600000) / 100;
    std::array<Estimate, kTiles> color;
    std::array<Estimate, kTiles> alpha;
    std::array<Estimate, kTiles> albedo;
    std::array<Estimate, kTiles> claimed;
    Estimate uneven;
    for (int seed = 0; seed < pictures; ++seed) {
        const RenderedImage image = render(GetParam(), static_cast<std::uint64_t>(seed));
        for (int tile = 0; tile < kTiles; ++tile) {
            const auto t = static_cast<std::size_t>(tile);
            color[t].add(mean_of(image, Aov::Color, tile));
            alpha[t].add(mean_of(image, Aov::Alpha, tile));
            albedo[t].add(mean_of(image, Aov::Albedo, tile));
            claimed[t].add(mean_of(image, Aov::Variance, tile) / kTileWidth);
        }
        uneven.add(mean_of(image, Aov::SampleCount, kTiles - 1) / static_cast<double>(GetParam()));
    }
    const boost::math::normal normal;
    const double limit = boost::math::quantile(boost::math::complement(normal, 1e-5 / 2 / (4 * 3 * kTiles)));
    double worst = 0;
    for (std::size_t t = 0; t < kTiles; ++t) {
        const double chance = chance_of(static_cast<int>(t));
        for (const auto& [estimate, truth] :
             {std::pair{&color[t], 1.0}, std::pair{&alpha[t], chance}, std::pair{&albedo[t], chance / 2}}) {
            const double z = (estimate->mean() - truth) / estimate->standard_error();
            worst = std::max(worst, std::abs(z));
            EXPECT_LT(std::abs(z), limit) << "tile " << t << ": " << estimate->mean() << " for " << truth;
        }
        // What they claim is how they scatter. The mean of passes that are no multiple of 8 weighs some samples more
        // than the claim has it.
        const double scatter = std::pow(color[t].standard_error(), 2) * pictures;
        if (GetParam() % kReplicates == 0) EXPECT_NEAR(claimed[t].mean() / scatter, 1, 0.15) << t;
    }
    RecordProperty("z", std::to_string(worst));
    EXPECT_GT(uneven.mean(), 1.2);
}

INSTANTIATE_TEST_SUITE_P(Passes, SamplePlanAfter, testing::Values(24, 27, 48));

TEST(SamplePlan, SpendsASampleAPixelAndKeepsAFloor) {
    for (std::uint64_t passes : {16U, 24U, 40U, 200U}) {
        const RenderedImage image = render(passes, 5);
        double all = 0;
        for (float n : image.find(Aov::SampleCount)->data) {
            EXPECT_GE(n, static_cast<float>(0.25 * static_cast<double>(passes) - 8));
            all += double{n};
        }
        // Up to one in each tile is rounded up or down in each replicate.
        EXPECT_NEAR(all / kWidth, static_cast<double>(passes), kReplicates) << passes;
    }
}

TEST(SamplePlan, IsEvenAtFirst) {
    const RenderedImage image = render(16, 6);
    for (float n : image.find(Aov::SampleCount)->data) EXPECT_EQ(n, 16);
    for (float n : image.find(Aov::Depth)->data) EXPECT_TRUE(n == 2 || std::isinf(n));
}

std::vector<TileReport> reports(const std::vector<double>& camera_noise, double splat_noise = 0) {
    std::vector<TileReport> tiles;
    for (double noise : camera_noise) tiles.push_back({256, {noise, splat_noise}, 4, 0});
    return tiles;
}

TEST(WantedSamples, GoByTheRootOfNoiseOverCost) {
    std::vector<TileReport> tiles = reports({1, 16, 100});
    EXPECT_EQ(wanted_samples(tiles), (std::vector<double>{0.1, 0.4, 1}));
    tiles[0].camera_rays *= 4;
    EXPECT_EQ(wanted_samples(tiles), (std::vector<double>{0.05, 0.4, 1}));
}

TEST(WantedSamples, AreTheSameWhereLittleIsToBeGained) {
    const std::vector<double> even(3, 1);
    EXPECT_EQ(wanted_samples(reports({1, 1.2, 1.5})), even);
    EXPECT_NE(wanted_samples(reports({1, 16, 100})), even);
    EXPECT_EQ(wanted_samples(reports({1, 16, 100}, 1000)), even);  // splats' noise stays
    EXPECT_EQ(wanted_samples(reports({0, 0, 0})), even);
    EXPECT_EQ(wanted_samples(reports({1, 16, INFINITY})), even);
    for (double wanted : wanted_samples(reports({0, 0, 1}))) EXPECT_GT(wanted, 0);
}

}  // namespace
}  // namespace etendue::test
