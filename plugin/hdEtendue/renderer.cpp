#include "renderer.h"

#include <exception>
#include <utility>

#include <pxr/base/tf/diagnostic.h>

namespace etendue::hydra {
namespace {

constexpr double kPatience = 0.01;          ///< seconds that a host is kept waiting for a picture
constexpr double kShortestInterval = 0.05;  ///< seconds between pictures: making one costs, too
constexpr double kLongestInterval = 0.25;   ///< seconds after which an unfinished pass is worth showing

}  // namespace

void Renderer::start(const SceneDescription& scene, const RenderSettings& settings) {
    stop();
    finished_ = false;
    shown_passes_ = -1;
    shown_at_ = Clock::now();
    try {
        auto session = std::make_unique<RenderSession>(scene, settings);
        session->set_paused(paused_);
        session->start();
        const std::lock_guard lock(mutex_);
        session_ = std::move(session);
    } catch (const std::exception& error) {
        fail(error);
    }
}

void Renderer::stop() {
    std::unique_ptr<RenderSession> ended;
    {
        const std::lock_guard lock(mutex_);
        ended = std::move(session_);
        statistics_ = {};
    }
    finished_ = true;
    // Destroyed without the lock: it waits for the render threads.
}

void Renderer::set_paused(bool paused) {
    const std::lock_guard lock(mutex_);
    paused_ = paused;
    if (session_) session_->set_paused(paused);
}

std::optional<RenderedImage> Renderer::fresh_image() {
    if (!session_ || finished_) return std::nullopt;
    const bool last = ended();
    const std::int64_t passes = session_->progress().passes_done;
    const double waited = std::chrono::duration<double>(Clock::now() - shown_at_).count();
    const bool due = (passes > shown_passes_ && waited >= kShortestInterval) || waited >= kLongestInterval;
    if (!last && !due) return std::nullopt;
    RenderedImage image = session_->snapshot();
    finished_ = last;
    shown_passes_ = passes;
    shown_at_ = Clock::now();
    const std::lock_guard lock(mutex_);
    statistics_ = image.statistics;
    return image;
}

Renderer::Status Renderer::status() const {
    const std::lock_guard lock(mutex_);
    Status status;
    if (session_) status.progress = session_->progress();
    status.statistics = statistics_;
    return status;
}

bool Renderer::ended() {
    if (!session_->wait_for(kPatience)) return false;
    try {
        session_->wait();
    } catch (const std::exception& error) {
        fail(error);
    }
    return true;
}

void Renderer::fail(const std::exception& error) {
    finished_ = true;
    TF_RUNTIME_ERROR("Etendue: %s", error.what());
}

}  // namespace etendue::hydra
