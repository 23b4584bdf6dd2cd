#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>

#include <etendue/render_session.h>

#include "usd.h"

namespace etendue::hydra {

/// One picture in the making. A failure is told once, as a runtime error of USD's, and ends the picture. The host's
/// thread starts it and takes pictures; any thread may ask how far it is.
class Renderer {
public:
    /// Starts anew; what was being rendered is dropped.
    void start(const SceneDescription& scene, const RenderSettings& settings);
    /// Ends rendering; what has been shown stays.
    void stop();
    /// Holds this render, and those started while held, or lets them go on.
    void set_paused(bool paused);
    [[nodiscard]] bool is_paused() const { return paused_; }

    /// The picture so far when it is worth another look: a pass more than last time, or a while later. Waits a moment
    /// for it, so that a host that asks in a loop leaves the processor to the render. Empty otherwise.
    [[nodiscard]] std::optional<RenderedImage> fresh_image();
    /// Whether the last fresh_image() was the last there is.
    [[nodiscard]] bool is_finished() const { return finished_; }

    struct Status {
        RenderProgress progress;
        RenderStatistics statistics;
    };
    [[nodiscard]] Status status() const;

private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] bool ended();
    void fail(const std::exception& error);

    mutable std::mutex mutex_;  ///< guards what other threads read: the session and the statistics
    std::unique_ptr<RenderSession> session_;
    RenderStatistics statistics_;
    std::atomic<bool> finished_{true};
    std::atomic<bool> paused_{false};
    std::int64_t shown_passes_ = -1;
    Clock::time_point shown_at_;
};

}  // namespace etendue::hydra
