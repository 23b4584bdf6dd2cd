// Renders that end when their error is small enough.

#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <thread>

#include <gtest/gtest.h>

#include <etendue/render_session.h>

#include "support/replicas.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

RenderSettings until(double error, IntegratorKind integrator = IntegratorKind::Bdpt) {
    RenderSettings settings = small_settings(integrator, 16, 0);
    settings.error_target = error;
    return settings;
}

class ErrorTarget : public testing::TestWithParam<IntegratorKind> {};

TEST_P(ErrorTarget, EndsTheRenderOnceReached) {
    double last = 1;
    for (double error : {0.1, 0.05}) {
        const RenderStatistics statistics = render(diffuse_box(), until(error, GetParam())).statistics;
        EXPECT_LT(statistics.error, error);
        EXPECT_GT(statistics.error, error / 2);
        EXPECT_LT(statistics.error, last);
        EXPECT_EQ(statistics.passes % 8, 0);
        last = statistics.error;
    }
}

INSTANTIATE_TEST_SUITE_P(Integrators, ErrorTarget,
                         testing::Values(IntegratorKind::Path, IntegratorKind::Light, IntegratorKind::Bdpt));

TEST(ErrorTarget, EndsAPictureThatHasNoneEarly) {
    SceneDescription dark = diffuse_box();
    dark.lights.clear();
    const RenderStatistics statistics = render(dark, until(0.01)).statistics;
    EXPECT_EQ(statistics.passes, 16);
    EXPECT_EQ(statistics.error, 0);
}

TEST(ErrorTarget, IsOneLimitOfThree) {
    RenderSettings settings = until(1e-6);
    settings.samples_per_pixel = 21;
    const RenderStatistics few = render(diffuse_box(), settings).statistics;
    EXPECT_EQ(few.passes, 21);
    EXPECT_GT(few.error, 1e-6);
    EXPECT_LT(few.error, 1);

    settings.samples_per_pixel = 0;
    settings.time_limit = 0.2;
    RenderSession brief(diffuse_box(), settings);
    brief.start();
    brief.wait();
    EXPECT_GE(brief.progress().seconds, 0.2);
    EXPECT_GT(brief.snapshot().statistics.error, 1e-6);

    settings = until(0.3);
    settings.samples_per_pixel = 100'000'000;
    settings.time_limit = 1000;
    EXPECT_LT(render(diffuse_box(), settings).statistics.error, 0.3);
}

// It is the error of the picture as it is at the end, whichever limit ended it.
TEST(ErrorTarget, IsClaimedForAllPasses) {
    RenderSettings settings = until(1e-6);
    settings.samples_per_pixel = 31;
    const double claimed = render(diffuse_box(), settings).statistics.error;
    settings.samples_per_pixel = 16;
    const double at_first_look = render(diffuse_box(), settings).statistics.error;
    EXPECT_LT(claimed, 0.9 * at_first_look);
    settings.samples_per_pixel = 31;
    settings.error_target = 0;
    settings.aovs.push_back(Aov::Variance);
    EXPECT_EQ(render(diffuse_box(), settings).statistics.error, claimed);
}

TEST(ErrorTarget, IsUnknownBeforeEveryReplicateHasAPass) {
    RenderSettings settings = until(0.1);
    settings.samples_per_pixel = 7;
    EXPECT_EQ(render(diffuse_box(), settings).statistics.error, kInfinity);
    settings.samples_per_pixel = 8;
    EXPECT_LT(render(diffuse_box(), settings).statistics.error, 10);
    settings.error_target = 0;
    EXPECT_EQ(render(diffuse_box(), settings).statistics.error, kInfinity);  // nobody asked
}

TEST(ErrorTarget, DoesNotDependOnThreads) {
    RenderSettings settings = until(0.1);
    settings.height = 37;  // more than one part, the last one short
    settings.filter = {FilterKind::Gaussian, 1.5};
    settings.threads = 1;
    const RenderedImage expected = render(diffuse_box(), settings);
    for (int threads : {2, 5}) {
        settings.threads = threads;
        const RenderedImage image = render(diffuse_box(), settings);
        EXPECT_EQ(image.statistics.passes, expected.statistics.passes);
        EXPECT_EQ(image.statistics.error, expected.statistics.error);
        EXPECT_EQ(image.find(Aov::Color)->data, expected.find(Aov::Color)->data);
    }
}

TEST(ErrorTarget, ShowsInProgress) {
    std::vector<RenderProgress> told;
    RenderSession session(diffuse_box(), until(0.05), [&](const RenderProgress& p) { told.push_back(p); });
    session.start();
    session.wait();
    ASSERT_GT(told.size(), 17U);
    for (std::size_t i = 0; i < 15; ++i) {
        EXPECT_EQ(told[i].error, kInfinity);
        EXPECT_EQ(told[i].fraction, 0);
        EXPECT_EQ(told[i].passes_total, 0);
    }
    const auto last = static_cast<double>(told.back().passes_done);
    for (std::size_t i = 15; i < told.size(); ++i) {
        EXPECT_LT(told[i].error, 1);
        // A forecast: the error's 1 / passes is a law of the mean, and the end is at the next look.
        EXPECT_NEAR(told[i].fraction, static_cast<double>(told[i].passes_done) / last, 0.3);
    }
    EXPECT_EQ(told.back().fraction, 1);
    EXPECT_TRUE(told.back().finished);
    EXPECT_EQ(told.back().error, session.snapshot().statistics.error);
    EXPECT_LT(told.back().error, 0.05);
}

/// Of the estimate at the first look, its standard error as part of it: what the forecast adds, twice.
double uncertainty(const PixelFilter& filter) {
    constexpr double kTarget = 1e-3;
    RenderSettings settings = until(kTarget, IntegratorKind::Light);
    settings.filter = filter;
    RenderProgress first;
    std::optional<RenderSession> session;
    session.emplace(diffuse_box(), settings, [&](const RenderProgress& p) {
        if (p.passes_done != 16 || p.finished) return;
        first = p;
        session->cancel();
    });
    session->start();
    session->wait();
    const double relative_mse = first.error * first.error;
    return (kTarget * kTarget / first.fraction / relative_mse - 1) / 2;
}

// A splat falls on all pixels that the filter reaches: they are right or wrong together.
TEST(ErrorTarget, IsLessSureUnderWideFilters) {
    const double narrow = uncertainty({FilterKind::Box, 0.5});
    EXPECT_GT(narrow, 1.0 / 16);  // 16 x 16 pixels, not all alike
    EXPECT_LT(narrow, 0.2);
    EXPECT_GT(uncertainty({FilterKind::Box, 1.5}), 2.5 * narrow);
}

TEST(ErrorTarget, IsClaimedOfCancelledRendersToo) {
    std::optional<RenderSession> session;
    session.emplace(diffuse_box(), until(1e-6), [&](const RenderProgress& p) {
        if (p.passes_done == 25) session->cancel();
    });
    session->start();
    session->wait();
    const RenderStatistics cancelled = session->snapshot().statistics;
    EXPECT_EQ(cancelled.passes, 25);
    RenderSettings settings = until(1e-6);
    settings.samples_per_pixel = 25;
    EXPECT_EQ(cancelled.error, render(diffuse_box(), settings).statistics.error);
}

}  // namespace
}  // namespace etendue::test
