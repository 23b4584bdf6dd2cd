// The error that a picture claims for itself is what it is off from the truth, whatever its noise looks like.

#include "film/relative_error.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include <etendue/film_view.h>

#include "math/rng.h"
#include "support/estimate.h"

namespace etendue::test {
namespace {

constexpr int kWidth = 24;
constexpr int kHeight = 20;
/// The estimate is biased a little, by what six replicates do not know: so much may be left, on either side.
constexpr double kBias = 0.1;
constexpr double kResolution = 0.05;

/// One pass of one pixel whose true value is `truth`.
using Noise = std::function<double(double truth, Rng& rng)>;

/// A picture with its true values.
struct Picture {
    std::vector<double> truth;
    ReplicateSums pixels;
};

/// Left dark, right bright, the lowest rows black.
std::vector<double> ramp() {
    std::vector<double> truth;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) truth.push_back(y < kHeight - 2 ? 0.1 + (x < 9 ? 0.0 : 1.0 + 0.1 * y) : 0.0);
    }
    return truth;
}

Picture picture(std::uint64_t passes, std::uint64_t seed, const Noise& noise, double scale = 1) {
    Picture p{ramp(), ReplicateSums(kWidth * kHeight)};
    Rng rng(seed, 0, 0);
    for (std::uint64_t pass = 0; pass < passes; ++pass) {
        for (std::size_t i = 0; i < p.truth.size(); ++i) {
            const double truth = p.truth[i];
            p.pixels.add_sample(i, scale * Rgb(noise(truth, rng), noise(truth, rng), noise(truth, rng)));
        }
        p.pixels.end_pass(0);
    }
    return p;
}

double actual(const Picture& p) {
    double mean = 0;
    for (double truth : p.truth) mean += truth / static_cast<double>(p.truth.size());
    double sum = 0;
    for (std::size_t i = 0; i < p.truth.size(); ++i) {
        const Rgb off = p.pixels.mean(i) - Rgb(p.truth[i]);
        sum += total(off * off) / 3 / (p.truth[i] * p.truth[i] + std::pow(kDarkestPart * mean, 2));
    }
    return sum / static_cast<double>(p.truth.size());
}

ErrorEstimate claimed(const Picture& p) { return RelativeError(p.pixels, kWidth).of_rows(0, kHeight).estimate(1); }

struct NoiseCase {
    const char* name;
    std::uint64_t passes;
    Noise noise;
};

class RelativeErrorOf : public testing::TestWithParam<NoiseCase> {};

TEST_P(RelativeErrorOf, IsTheActualOne) {
    const NoiseCase& c = GetParam();
    Estimate ratio;
    const int pictures = samples(6000) / 100;
    for (int i = 0; i < pictures; ++i) {
        const Picture p = picture(c.passes, static_cast<std::uint64_t>(i), c.noise);
        ratio.add(actual(p) / claimed(p).value);
    }
    RecordProperty("ratio", std::to_string(ratio.mean()));
    if (!full_effort()) return;
    EXPECT_NEAR(ratio.mean(), 1, kBias + kSigmas * ratio.standard_error());
    EXPECT_LT(kSigmas * ratio.standard_error(), kResolution);
}

double uniform_noise(double truth, Rng& rng) { return truth * 2 * rng.next_1d(); }

/// Most passes see little, one in fifty what the others miss.
double rare(double truth, Rng& rng) { return truth * (rng.next_1d() < 0.02 ? 25.5 : 0.5); }

INSTANTIATE_TEST_SUITE_P(Noises, RelativeErrorOf,
                         testing::Values(NoiseCase{"even", 32, uniform_noise}, NoiseCase{"strong", 8, uniform_noise},
                                         NoiseCase{"uneven_replicates", 43, uniform_noise},
                                         NoiseCase{"skewed", 128, rare}, NoiseCase{"fireflies", 32, rare}),
                         [](const auto& test) { return test.param.name; });

// A unit of radiance is anybody's choice.
TEST(RelativeError, HasNoScale) {
    const double expected = claimed(picture(16, 1, uniform_noise)).value;
    for (double scale : {1e-30, 1e30}) {
        EXPECT_NEAR(claimed(picture(16, 1, uniform_noise, scale)).value, expected, 1e-9 * expected);
    }
}

TEST(RelativeError, PartsAddUpToTheWhole) {
    const Picture p = picture(16, 2, uniform_noise);
    const RelativeError error(p.pixels, kWidth);
    ErrorSums sums;
    for (int y = 0; y < error.height(); y += 3) sums += error.of_rows(y, std::min(y + 3, error.height()));
    const ErrorEstimate whole = claimed(p);
    EXPECT_NEAR(sums.estimate(1).value, whole.value, 1e-12 * whole.value);
    EXPECT_NEAR(sums.estimate(1).standard_error, whole.standard_error, 1e-12 * whole.value);
}

TEST(RelativeError, IsZeroWherePassesAgree) {
    for (double level : {0.0, 3.0}) {
        const Picture p = picture(16, 3, [=](double, Rng&) { return level; });
        EXPECT_EQ(claimed(p).value, 0);
        EXPECT_EQ(claimed(p).standard_error, 0);
    }
}

// An estimate that rests on one pixel says so: it is about as uncertain as large.
TEST(RelativeError, OfOneFireflyIsUncertain) {
    Picture p = picture(16, 4, uniform_noise);
    const ErrorEstimate calm = claimed(p);
    EXPECT_LT(calm.standard_error, 0.1 * calm.value);
    for (std::uint64_t pass = 0; pass < kReplicates; ++pass) {
        if (pass == 3) p.pixels.add_sample(kWidth * 5 + 7, Rgb(1e4));
        p.pixels.end_pass(0);
    }
    const ErrorEstimate struck = claimed(p);
    EXPECT_GT(struck.value, 100 * calm.value);
    EXPECT_GT(struck.standard_error, 0.9 * struck.value);
}

TEST(RelativeError, IsLessSureWherePixelsShareTheirNoise) {
    ErrorSums sums;
    for (int i = 0; i < 100; ++i) sums.add(i % 2);  // rests on 50 pixels
    EXPECT_DOUBLE_EQ(sums.estimate(1).value, 0.5);
    EXPECT_DOUBLE_EQ(sums.estimate(1).standard_error, 0.5 / std::sqrt(50));
    EXPECT_DOUBLE_EQ(sums.estimate(9).standard_error, 3 * 0.5 / std::sqrt(50));
}

}  // namespace
}  // namespace etendue::test
