// Starting, stopping and looking at renders that run.

#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include <etendue/render_session.h>

#include "support/estimate.h"
#include "support/replicas.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

using Clock = std::chrono::steady_clock;

/// A work unit takes milliseconds here; what is left is for a busy machine.
constexpr double kPrompt = 10;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

RenderSettings endless(IntegratorKind integrator, int size) { return small_settings(integrator, size, 1000000000); }

TEST(Lifetime, NothingHappensBeforeStart) {
    RenderSession session(diffuse_box(), small_settings(IntegratorKind::Bdpt, 8, 1));
    session.wait();  // does not hang
    EXPECT_TRUE(session.wait_for(0));
    const RenderedImage image = session.snapshot();
    EXPECT_EQ(image.statistics.passes, 0);
    for (float v : image.find(Aov::Color)->data) EXPECT_EQ(v, 0);
}

TEST(Lifetime, StartingTwiceIsStartingOnce) {
    RenderSession session(diffuse_box(), small_settings(IntegratorKind::Bdpt, 8, 3));
    session.start();
    session.start();
    session.wait();
    session.start();
    session.wait();
    EXPECT_EQ(session.snapshot().statistics.passes, 3);
}

TEST(Lifetime, CancelReturnsPromptly) {
    RenderSession session(diffuse_box(), endless(IntegratorKind::Bdpt, 64));
    session.start();
    EXPECT_FALSE(session.wait_for(0.05));
    const auto begin = Clock::now();
    session.cancel();
    session.wait();
    EXPECT_LT(seconds_since(begin), kPrompt);
    EXPECT_TRUE(session.progress().finished);
    EXPECT_TRUE(session.wait_for(0));
}

TEST(Lifetime, CancelBeforeStartLeavesNothingToDo) {
    RenderSession session(diffuse_box(), endless(IntegratorKind::Path, 8));
    session.cancel();
    session.start();
    session.wait();
    EXPECT_EQ(session.snapshot().statistics.camera_paths, 0U);
}

TEST(Lifetime, DestructionEndsTheRender) {
    const auto begin = Clock::now();
    for (int i = 0; i < 5; ++i) {
        RenderSession session(diffuse_box(), endless(IntegratorKind::Bdpt, 32));
        session.start();
        if (i % 2 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    const RenderSession never_started(diffuse_box(), endless(IntegratorKind::Bdpt, 32));
    EXPECT_LT(seconds_since(begin), kPrompt);
}

TEST(Lifetime, APausedRenderStandsStill) {
    const RenderSettings settings = small_settings(IntegratorKind::Bdpt, 24, 6);
    RenderSession session(diffuse_box(), settings);
    session.set_paused(true);
    session.start();
    EXPECT_FALSE(session.wait_for(0.3));  // the whole render takes a fraction of that
    EXPECT_EQ(session.progress().passes_done, 0);
    session.set_paused(false);
    session.wait();
    EXPECT_EQ(session.snapshot().find(Aov::Color)->data, render(diffuse_box(), settings).find(Aov::Color)->data);
}

TEST(Lifetime, APausedRenderCanBeCancelled) {
    RenderSession session(diffuse_box(), endless(IntegratorKind::Bdpt, 32));
    session.start();
    session.set_paused(true);
    EXPECT_FALSE(session.wait_for(0.1));
    const auto begin = Clock::now();
    session.cancel();
    session.wait();
    EXPECT_LT(seconds_since(begin), kPrompt);
}

TEST(Lifetime, SessionsMayBeMovedWhileRendering) {
    RenderSession session(diffuse_box(), small_settings(IntegratorKind::Bdpt, 24, 8));
    session.start();
    RenderSession moved(std::move(session));
    RenderSession assigned(sky(), endless(IntegratorKind::Path, 16));
    assigned.start();
    assigned = std::move(moved);  // ends the other render
    assigned.wait();
    EXPECT_EQ(assigned.snapshot().find(Aov::Color)->data,
              render(diffuse_box(), small_settings(IntegratorKind::Bdpt, 24, 8)).find(Aov::Color)->data);
}

TEST(Lifetime, SnapshotsMayBeTakenWhileRendering) {
    RenderSettings settings = endless(IntegratorKind::Bdpt, 40);
    settings.aovs = {Aov::Color, Aov::SampleCount, Aov::Variance};
    RenderSession session(diffuse_box(), settings);
    session.start();
    std::uint64_t before = 0;
    std::thread canceller([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        session.cancel();
    });
    while (!session.wait_for(0.005)) {
        const RenderedImage image = session.snapshot();
        EXPECT_GE(image.statistics.camera_paths, before);
        before = image.statistics.camera_paths;
        double samples_taken = 0;
        for (float n : image.find(Aov::SampleCount)->data) samples_taken += static_cast<double>(n);
        EXPECT_EQ(samples_taken, static_cast<double>(before));  // pixels and statistics are of one moment
        for (float v : image.find(Aov::Color)->data) ASSERT_TRUE(std::isfinite(v) && v >= 0);
    }
    canceller.join();
    session.wait();
    EXPECT_GT(before, 0U);
}

// Work units arrive in order, and no sample depends on how many there will be: a render that was stopped shows the
// beginning of one that was not.
TEST(Lifetime, StoppedRendersAreTheBeginningOfWholeOnes) {
    RenderSettings settings = small_settings(IntegratorKind::Path, 40, 3);
    const RenderedImage whole = render(diffuse_box(), settings);
    settings.samples_per_pixel = 1000000000;
    std::optional<RenderSession> session;
    session.emplace(diffuse_box(), settings, [&](const RenderProgress& p) {
        if (p.passes_done == 3) session->cancel();
    });
    session->start();
    session->wait();
    const RenderedImage stopped = session->snapshot();
    EXPECT_EQ(stopped.statistics.passes, 3);
    EXPECT_EQ(stopped.find(Aov::Color)->data, whole.find(Aov::Color)->data);
}

// A pass cut short gives some pixels a sample more and splats over the light paths traced: the mean stays.
class PartialPass : public testing::TestWithParam<IntegratorKind> {};

TEST_P(PartialPass, IsUnbiased) {
    RenderSettings settings = small_settings(GetParam(), 48, 4);
    settings.threads = 1;
    const SceneDescription scene = diffuse_box();
    const auto mean_of = [](const RenderedImage& image) {
        double sum = 0;
        for (float v : image.find(Aov::Color)->data) sum += static_cast<double>(v);
        return sum / static_cast<double>(image.find(Aov::Color)->data.size());
    };
    Estimate whole;
    Estimate partial;
    int cut_short = 0;
    const int renders = samples(2400) / 100;
    for (int i = 0; i < renders; ++i) {
        settings.seed = static_cast<std::uint64_t>(2 * i);
        settings.samples_per_pixel = 4;
        whole.add(mean_of(render(scene, settings)));
        // Stops in the middle of some later pass, by when a second thread happens to look.
        settings.seed = static_cast<std::uint64_t>(2 * i + 1);
        settings.samples_per_pixel = 1000000000;
        RenderSession session(scene, settings);
        session.start();
        while (session.progress().passes_done < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        session.cancel();
        session.wait();
        const RenderedImage image = session.snapshot();
        const auto full = static_cast<std::uint64_t>(image.statistics.passes) * 48 * 48;
        if (image.statistics.camera_paths > full || image.statistics.light_paths > full) ++cut_short;
        partial.add(mean_of(image));
    }
    EXPECT_GT(cut_short, 0);
    EXPECT_TRUE(agree(whole, partial, 0.01));
}

INSTANTIATE_TEST_SUITE_P(Integrators, PartialPass,
                         testing::Values(IntegratorKind::Path, IntegratorKind::Light, IntegratorKind::Bdpt));

// The one thing a test can make fail in the middle of a render is its callback.
TEST(Lifetime, WaitRethrowsWhatEndedTheRender) {
    RenderSession session(diffuse_box(), endless(IntegratorKind::Path, 8), [](const RenderProgress& p) {
        if (!p.finished) throw std::runtime_error("stop here");
    });
    session.start();
    for (int i = 0; i < 2; ++i) {
        try {
            session.wait();
            ADD_FAILURE() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "stop here");
        }
    }
    EXPECT_TRUE(session.progress().finished);
    EXPECT_EQ(session.snapshot().statistics.passes, 1);
}

}  // namespace
}  // namespace etendue::test
