#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include <gtest/gtest.h>

#include <etendue/render_session.h>

#include "support/replicas.h"
#include "support/tiny_scenes.h"

namespace etendue::test {
namespace {

/// What a callback was told.
class Record {
public:
    ProgressCallback callback() {
        return [this](const RenderProgress& p) {
            EXPECT_EQ(inside_.fetch_add(1), 0);  // never concurrently with itself
            progress_.push_back(p);
            --inside_;
        };
    }
    [[nodiscard]] const std::vector<RenderProgress>& all() const { return progress_; }

private:
    std::atomic<int> inside_{0};
    std::vector<RenderProgress> progress_;
};

void expect_monotone(const std::vector<RenderProgress>& all) {
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_GE(all[i].fraction, 0);
        EXPECT_LE(all[i].fraction, 1);
        EXPECT_EQ(all[i].finished, i + 1 == all.size());
        if (i == 0) continue;
        EXPECT_GE(all[i].passes_done, all[i - 1].passes_done);
        EXPECT_GE(all[i].fraction, all[i - 1].fraction);
        EXPECT_GE(all[i].seconds, all[i - 1].seconds);
    }
}

TEST(Progress, IsToldAfterEveryPassAndAtTheEnd) {
    Record record;
    RenderSession session(diffuse_box(), small_settings(IntegratorKind::Bdpt, 20, 10), record.callback());
    EXPECT_EQ(session.progress().passes_done, 0);
    EXPECT_EQ(session.progress().passes_total, 10);
    EXPECT_EQ(session.progress().fraction, 0);
    EXPECT_EQ(session.progress().seconds, 0);
    EXPECT_FALSE(session.progress().finished);
    session.start();
    session.wait();
    // Nobody is told anything once wait() has returned.
    ASSERT_EQ(record.all().size(), 11U);
    expect_monotone(record.all());
    EXPECT_EQ(record.all()[3].passes_done, 4);
    EXPECT_DOUBLE_EQ(record.all()[3].fraction, 0.4);
    EXPECT_EQ(record.all().back().passes_done, 10);
    EXPECT_EQ(record.all().back().fraction, 1);
    EXPECT_TRUE(session.progress().finished);
    EXPECT_EQ(session.progress().seconds, session.progress().seconds);
}

// Whoever waits may then take apart what the callback uses: it must have been called for the last time.
TEST(Progress, TheLastCallComesBeforeWaitReturns) {
    std::atomic<bool> told{false};
    RenderSession session(diffuse_box(), small_settings(IntegratorKind::Path, 4, 1), [&](const RenderProgress& p) {
        if (!p.finished) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        told = true;
    });
    session.start();
    while (!session.progress().finished) std::this_thread::yield();
    session.wait();
    EXPECT_TRUE(told);
}

TEST(Progress, KnowsTheTimeLimit) {
    Record record;
    RenderSettings settings = small_settings(IntegratorKind::Path, 16, 0);
    settings.time_limit = 0.3;
    RenderSession session(diffuse_box(), settings, record.callback());
    EXPECT_EQ(session.progress().passes_total, 0);
    session.start();
    session.wait();
    EXPECT_GE(session.progress().seconds, 0.3);
    // Units take milliseconds; the rest is for a machine that does other things too.
    EXPECT_LT(session.progress().seconds, 10);
    EXPECT_EQ(session.progress().fraction, 1);
    expect_monotone(record.all());
    const RenderedImage image = session.snapshot();
    EXPECT_GT(image.statistics.passes, 0);
    EXPECT_EQ(image.statistics.seconds, session.progress().seconds);
}

TEST(Progress, WhicheverLimitComesFirstEndsTheRender) {
    RenderSettings settings = small_settings(IntegratorKind::Path, 8, 2);
    settings.time_limit = 1000;
    RenderSession few(diffuse_box(), settings);
    few.start();
    few.wait();
    EXPECT_EQ(few.progress().passes_done, 2);
    settings.samples_per_pixel = 100000000;
    settings.time_limit = 0.1;
    RenderSession brief(diffuse_box(), settings);
    brief.start();
    brief.wait();
    EXPECT_LT(brief.progress().passes_done, 100000000);
    EXPECT_EQ(brief.progress().fraction, 1);
}

}  // namespace
}  // namespace etendue::test
