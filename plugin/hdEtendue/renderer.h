#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <etendue/render_session.h>

#include "identifiers.h"
#include "usd.h"

namespace etendue::hydra {

/// What to render.
struct RenderJob {
    SceneDescription scene;
    RenderSettings settings;
    PrimTable prims;
    bool identify = false;  ///< whether anybody asks which prims the pixels show
};

/// What there is to show of a render.
struct RenderView {
    RenderedImage image;
    std::shared_ptr<const Identifiers> identifiers;  ///< null unless asked for, and while they are not known
};

/// One picture in the making. Scenes are built and rendered in the background, and what an edit leaves alone is not
/// built again. A failure is told once, as a runtime error of USD's, on the thread that asks for the picture.
class Renderer {
public:
    Renderer();
    /// Waits for what is being built.
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Begins anew and returns at once; what was being rendered is dropped, and what was waiting, too.
    void start(RenderJob job);
    /// Ends rendering; what has been shown stays. `wait`: returns once no thread works at it.
    void stop(bool wait);
    /// The next start() builds everything, and reads every file.
    void forget();
    /// Holds this render, and those started while held, or lets them go on.
    void set_paused(bool paused);

    /// The picture so far when it is worth another look: a pass more than last time, or a while later. Waits a moment
    /// for it, so that a host that asks in a loop leaves the processor to the render. Empty otherwise.
    [[nodiscard]] std::optional<RenderView> fresh_view();
    /// Whether the last fresh_view() was the last there is.
    [[nodiscard]] bool is_finished() const { return finished_; }
    /// Whether that is because something went wrong.
    [[nodiscard]] bool has_failed() const { return failed_; }

    struct Status {
        RenderProgress progress;
        RenderStatistics statistics;
    };
    [[nodiscard]] Status status() const;

private:
    using Clock = std::chrono::steady_clock;
    using Session = std::shared_ptr<RenderSession>;

    void work();
    void do_job(std::unique_lock<std::mutex>& lock, const RenderJob& job);
    [[nodiscard]] static Session build(const RenderJob& job, const Session& before, std::string& failure);
    [[nodiscard]] bool begin(const Session& session, std::string failure);
    [[nodiscard]] Session wait_for_session();
    [[nodiscard]] bool has_ended(RenderSession& session);
    void fail(const std::string& why);

    mutable std::mutex mutex_;  ///< guards all that is not atomic, but for what fresh_view() alone uses
    std::condition_variable changed_;
    std::optional<RenderJob> waiting_;
    std::atomic<std::uint64_t> request_{0};  ///< grows with every start and stop
    bool building_ = false;
    bool rebuild_ = false;  ///< the next one, from nothing
    bool quit_ = false;
    Session session_;       ///< what is rendered, or the last that was
    bool current_ = false;  ///< whether that is what start() asked for
    bool identify_ = false;
    std::shared_ptr<const Identifiers> identifiers_;  ///< null until they are known
    std::string failure_;                             ///< why there is nothing to render
    RenderStatistics statistics_;
    std::atomic<bool> finished_{true};
    std::atomic<bool> paused_{false};
    bool failed_ = false;
    std::int64_t shown_passes_ = -1;
    Clock::time_point shown_at_;
    std::thread worker_;  ///< the last: it uses the others
};

}  // namespace etendue::hydra
