#include "film/film.h"

#include <limits>

#include <gtest/gtest.h>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>

#include "film/replicates.h"
#include "math/rng.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

RenderSettings settings(int width, int height, const std::vector<Aov>& aovs) {
    RenderSettings s;
    s.width = width;
    s.height = height;
    s.aovs = aovs;
    return s;
}

FilmTile tile_of(const PixelWindow& window, const Rgb& radiance) {
    FilmTile tile;
    tile.reset(window);
    const auto pixels = static_cast<std::size_t>((window.x1 - window.x0) * (window.y1 - window.y0));
    tile.samples.assign(pixels, {radiance, false, 0, {}, {}});
    return tile;
}

float at(const RenderedImage& image, Aov aov, int x, int y, int channel = 0) {
    const AovImage& a = *image.find(aov);
    return a.data[static_cast<std::size_t>((y * image.width + x) * a.channels + channel)];
}

TEST(Film, PixelsAreMeansOfSamples) {
    const PixelWindow window{0, 0, 4, 3};
    Film film(settings(4, 3, {Aov::Color, Aov::SampleCount}), window);
    film.add(tile_of(window, {1, 2, 3}));
    film.add(tile_of({1, 1, 2, 3}, {5, 2, 3}));  // a tile within
    const RenderedImage image = film.image();
    EXPECT_EQ(at(image, Aov::Color, 0, 0), 1);
    EXPECT_EQ(at(image, Aov::Color, 1, 1), 3);
    EXPECT_EQ(at(image, Aov::Color, 1, 2, 2), 3);
    EXPECT_EQ(at(image, Aov::Color, 2, 1), 1);
    EXPECT_EQ(at(image, Aov::SampleCount, 1, 2), 2);
    EXPECT_EQ(at(image, Aov::SampleCount, 1, 0), 1);
}

TEST(Film, PixelsWithoutSamplesAreBlack) {
    const Film film(settings(2, 2, {Aov::Color, Aov::Alpha, Aov::Depth, Aov::Normal, Aov::Albedo, Aov::Variance}),
                    {0, 0, 2, 2});
    const RenderedImage image = film.image();
    EXPECT_EQ(at(image, Aov::Color, 0, 0), 0);
    EXPECT_EQ(at(image, Aov::Alpha, 0, 0), 0);
    EXPECT_EQ(at(image, Aov::Depth, 0, 0), std::numeric_limits<float>::infinity());
    EXPECT_EQ(at(image, Aov::Normal, 0, 0), 0);
    EXPECT_EQ(at(image, Aov::Variance, 0, 0), std::numeric_limits<float>::infinity());
}

// A splat is a sample of the filter's density at the pixel, over the number of light paths.
TEST(Film, SplatsAreSpreadByTheFilterAndSharedByLightPaths) {
    for (FilterKind kind : {FilterKind::Box, FilterKind::Triangle, FilterKind::Gaussian}) {
        RenderSettings s = settings(9, 9, {Aov::Color});
        s.filter = {kind, kind == FilterKind::Box ? 0.5 : 2.0};
        const PixelWindow window{0, 0, 9, 9};
        Film film(s, window);
        FilmTile tile = tile_of(window, {});
        tile.light_paths = 50;
        tile.add_splat({4.3, 4.8}, {100, 50, 0});
        film.add(tile);
        FilmTile more = tile_of(window, {});
        more.light_paths = 50;
        film.add(more);
        const RenderedImage image = film.image();
        const Filter filter(s.filter);
        double sum = 0;
        for (int y = 0; y < 9; ++y) {
            for (int x = 0; x < 9; ++x) {
                const double weight = filter.eval({4.3 - x - 0.5, 4.8 - y - 0.5});
                EXPECT_NEAR(at(image, Aov::Color, x, y), weight, 1e-6);
                EXPECT_NEAR(at(image, Aov::Color, x, y, 1), weight / 2, 1e-6);
                sum += at(image, Aov::Color, x, y);
            }
        }
        // Sums of the density over the grid: exact for box and triangle, a Gaussian of sigma 2/3 cut at 3 sigma almost.
        EXPECT_NEAR(sum, 1, kind == FilterKind::Gaussian ? 0.02 : 1e-6);
    }
}

TEST(Film, SplatsBeyondTheEdgeLeaveTheirShare) {
    RenderSettings s = settings(8, 8, {Aov::Color});
    s.filter = {FilterKind::Triangle, 1.5};
    const PixelWindow crop{2, 3, 5, 6};
    Film film(s, crop);
    FilmTile tile = tile_of(crop, {});
    tile.light_paths = 1;
    for (const Vec2& raster : {Vec2{1.6, 4.5}, Vec2{5.9, 6.2}, Vec2{0.4, 0.4}, Vec2{-3, 4}, Vec2{1e9, -1e9}}) {
        tile.add_splat(raster, Rgb(1));
    }
    film.add(tile);
    const RenderedImage image = film.image();
    const Filter filter(s.filter);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 3; ++x) {
            const double px = x + 2.5;
            const double py = y + 3.5;
            const double expected = filter.eval({1.6 - px, 4.5 - py}) + filter.eval({5.9 - px, 6.2 - py});
            EXPECT_NEAR(at(image, Aov::Color, x, y), expected, 1e-6);
        }
    }
    EXPECT_EQ(image.window.x0, 2);
    EXPECT_EQ(image.width, 3);
    EXPECT_EQ(image.full_width, 8);
}

TEST(Film, SurfaceAovsAreMeansOverWhatWasHit) {
    const PixelWindow window{0, 0, 1, 1};
    Film film(settings(1, 1, {Aov::Alpha, Aov::Depth, Aov::Normal, Aov::Albedo}), window);
    FilmTile tile;
    for (double depth : {2.0, 4.0}) {
        tile.reset(window);
        tile.samples.push_back({{}, true, depth, {0, depth / 4, 1}, Rgb(depth)});
        film.add(tile);
    }
    film.add(tile_of(window, {}));
    film.add(tile_of(window, {}));
    const RenderedImage image = film.image();
    EXPECT_FLOAT_EQ(at(image, Aov::Alpha, 0, 0), 0.5F);
    EXPECT_FLOAT_EQ(at(image, Aov::Depth, 0, 0), 3);          // of hits
    EXPECT_FLOAT_EQ(at(image, Aov::Normal, 0, 0, 1), 0.75F);  // of hits
    EXPECT_FLOAT_EQ(at(image, Aov::Normal, 0, 0, 2), 1);
    EXPECT_FLOAT_EQ(at(image, Aov::Albedo, 0, 0), 1.5F);  // of all samples: what a denoiser divides colour by
}

TEST(Film, InvalidContributionsAreCountedByKindAndNeverAdded) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    FilmTile tile;
    const PixelWindow window{0, 0, 2, 2};
    tile.reset(window);
    for (const Rgb& c : {Rgb(nan, 1, 1), Rgb(1, nan, -1), Rgb(1, inf, nan)}) EXPECT_FALSE(tile.accept(c));
    for (const Rgb& c : {Rgb(inf, 1, 1), Rgb(1, 1, -inf), Rgb(-1, inf, 0)}) EXPECT_FALSE(tile.accept(c));
    for (const Rgb& c : {Rgb(-1, 1, 1), Rgb(1, -1e-300, 1)}) EXPECT_FALSE(tile.accept(c));
    for (const Rgb& c : {Rgb(0), Rgb(1, 2, 3), Rgb(1e308, 1e308, 1e308), Rgb(-0.0)}) EXPECT_TRUE(tile.accept(c));
    EXPECT_EQ(tile.invalid, (std::array<std::uint64_t, kInvalidKinds>{3, 3, 2}));
    tile.add_splat({1, 1}, Rgb(nan));
    tile.add_splat({1, 1}, Rgb(-1));
    EXPECT_TRUE(tile.splats.empty());
    tile.samples.resize(4);
    Film film(settings(2, 2, {Aov::Color}), window);
    film.add(tile);
    film.add(tile);
    const RenderStatistics statistics = film.image().statistics;
    EXPECT_EQ(statistics.invalid[static_cast<std::size_t>(InvalidKind::NotANumber)], 8U);
    EXPECT_EQ(statistics.invalid[static_cast<std::size_t>(InvalidKind::Infinite)], 6U);
    EXPECT_EQ(statistics.invalid[static_cast<std::size_t>(InvalidKind::Negative)], 6U);
    EXPECT_EQ(at(film.image(), Aov::Color, 1, 1), 0);
}

TEST(Film, AddsUpStatistics) {
    const PixelWindow window{0, 0, 1, 1};
    Film film(settings(1, 1, {}), window);
    FilmTile tile = tile_of(window, {});
    tile.camera_paths = 1;
    tile.light_paths = 2;
    tile.rays = 3;
    for (int i = 0; i < 5; ++i) {
        film.add(tile);
        film.end_pass();
    }
    const RenderedImage image = film.image();
    EXPECT_TRUE(image.aovs.empty());
    EXPECT_EQ(image.statistics.camera_paths, 5U);
    EXPECT_EQ(image.statistics.light_paths, 10U);
    EXPECT_EQ(image.statistics.rays, 15U);
    EXPECT_EQ(image.statistics.passes, 5);
}

// Passes of Gaussian pixels, part sample and part splat, and replicates of one or two of them: (replicates - 1) passes
// claimed / sigma^2 follows chi-squared.
TEST(Film, VarianceIsThatOfTheMean) {
    const boost::math::normal gauss;
    const int passes = 13;
    constexpr auto kDegrees = static_cast<double>(kReplicates - 1);
    const PixelWindow window{0, 0, 16, 16};
    Film film(settings(16, 16, {Aov::Variance, Aov::Color}), window);
    Rng rng(1, 0, 0);
    const auto draw = [&] { return boost::math::quantile(gauss, rng.next_1d() + 0x1p-54); };
    const double camera_sigma = 2;
    const double splat_sigma = 1.5;
    for (int pass = 0; pass < passes; ++pass) {
        FilmTile tile = tile_of(window, {});
        tile.light_paths = 7;
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 16; ++x) {
                // Far from 0: what sums of squares would lose to cancellation.
                tile.samples[static_cast<std::size_t>(y * 16 + x)].radiance = Rgb(1e6 + camera_sigma * draw());
                tile.add_splat({x + 0.5, y + 0.5}, Rgb(7 * (1e6 + splat_sigma * draw())));
            }
        }
        film.add(tile);
        film.end_pass();
    }
    const RenderedImage image = film.image();
    double statistic = 0;
    const double sigma2 = camera_sigma * camera_sigma + splat_sigma * splat_sigma;
    for (int i = 0; i < 256; ++i) statistic += passes * kDegrees * at(image, Aov::Variance, i % 16, i / 16) / sigma2;
    // Two-sided, a false alarm in 10^6 seeds: with 1792 degrees of freedom that resolves 17 % in the variance. An n in
    // place of n - 1, 14 %, is four of its standard deviations away.
    const boost::math::chi_squared chi2(256 * kDegrees);
    EXPECT_GT(statistic, boost::math::quantile(chi2, 5e-7));
    EXPECT_LT(statistic, boost::math::quantile(boost::math::complement(chi2, 5e-7)));
}

TEST(Film, VarianceKnowsCompletePassesOnly) {
    const PixelWindow window{0, 0, 1, 1};
    Film film(settings(1, 1, {Aov::Variance}), window);
    film.add(tile_of(window, Rgb(1)));
    film.end_pass();
    EXPECT_EQ(at(film.image(), Aov::Variance, 0, 0), std::numeric_limits<float>::infinity());
    film.add(tile_of(window, Rgb(3)));
    film.end_pass();
    EXPECT_FLOAT_EQ(at(film.image(), Aov::Variance, 0, 0), 1);  // ((1 - 2)^2 + (3 - 2)^2) / (2 * 1)
    film.add(tile_of(window, Rgb(100)));                        // not complete
    EXPECT_FLOAT_EQ(at(film.image(), Aov::Variance, 0, 0), 1);
}

TEST(Film, VarianceIsThatOfReplicates) {
    const PixelWindow window{0, 0, 1, 1};
    Film film(settings(1, 1, {Aov::Variance}), window);
    // What replicates add up to is far less scattered than their passes are.
    for (double above : {5.0, -5.0}) {
        for (std::uint64_t replicate = 0; replicate < kReplicates; ++replicate) {
            film.add(tile_of(window, Rgb(10 + above + (replicate % 2 == 0 ? 1 : -1))));
            film.end_pass();
        }
    }
    constexpr double kVariance = 1.0 / (kReplicates - 1);  // 8 deviations of 1^2 over 8 * 7
    EXPECT_FLOAT_EQ(at(film.image(), Aov::Variance, 0, 0), static_cast<float>(kVariance));
}

}  // namespace
}  // namespace etendue::test
