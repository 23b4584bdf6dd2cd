#include "renderer.h"

#include <algorithm>
#include <exception>
#include <utility>

#include <pxr/base/tf/diagnostic.h>

namespace etendue::hydra {
namespace {

constexpr std::chrono::milliseconds kPatience{10};  ///< that a host is kept waiting for a picture
constexpr double kShortestInterval = 0.05;          ///< seconds between pictures: making one costs, too
constexpr double kLongestInterval = 0.25;           ///< seconds after which an unfinished pass is worth showing

}  // namespace

Renderer::Renderer() : shown_at_(Clock::now()), worker_([this] { work(); }) {}

Renderer::~Renderer() {
    stop(false);
    {
        const std::lock_guard lock(mutex_);
        quit_ = true;
    }
    changed_.notify_all();
    worker_.join();
}

void Renderer::start(RenderJob job) {
    {
        const std::lock_guard lock(mutex_);
        if (session_) session_->cancel();
        waiting_ = std::move(job);
        ++request_;
        current_ = false;
        failure_.clear();
        statistics_ = {};
    }
    finished_ = false;
    failed_ = false;
    shown_passes_ = -1;
    shown_at_ = Clock::now();
    changed_.notify_all();
}

void Renderer::stop(bool wait) {
    Session ended;
    {
        std::unique_lock lock(mutex_);
        if (session_) session_->cancel();
        waiting_.reset();
        ++request_;
        current_ = false;
        failure_.clear();
        statistics_ = {};
        finished_ = true;
        if (wait) changed_.wait(lock, [this] { return !building_; });
        ended = session_;
    }
    while (wait && ended && !ended->wait_for(1)) {
    }
}

void Renderer::forget() {
    const std::lock_guard lock(mutex_);
    rebuild_ = true;
}

void Renderer::set_paused(bool paused) {
    const std::lock_guard lock(mutex_);
    paused_ = paused;
    if (session_) session_->set_paused(paused);
}

void Renderer::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return quit_ || waiting_; });
        if (quit_) return;
        const RenderJob job = std::move(*waiting_);
        waiting_.reset();
        building_ = true;
        do_job(lock, job);
        building_ = false;
        changed_.notify_all();
    }
}

/// Comes and goes with the lock; works without it.
void Renderer::do_job(std::unique_lock<std::mutex>& lock, const RenderJob& job) {
    const std::uint64_t request = request_;
    Session before = std::exchange(rebuild_, false) ? nullptr : session_;
    Session dropped = before ? nullptr : std::move(session_);
    identifiers_.reset();
    identify_ = job.identify;
    lock.unlock();
    dropped.reset();  // waits for the render's threads
    std::string failure;
    const Session next = build(job, before, failure);
    lock.lock();
    if (next) session_ = next;
    const bool begun = request == request_ && begin(next, std::move(failure));
    changed_.notify_all();
    lock.unlock();
    before.reset();
    std::shared_ptr<const Identifiers> identifiers;
    if (begun && job.identify) {
        const auto is_stale = [&] { return request != request_; };
        identifiers = std::make_shared<const Identifiers>(identify(*next, *job.settings.crop, job.prims, is_stale));
    }
    lock.lock();
    if (request == request_) identifiers_ = std::move(identifiers);
}

/// Null, and why, where there is nothing to render.
Renderer::Session Renderer::build(const RenderJob& job, const Session& before, std::string& failure) {
    try {
        return std::make_shared<RenderSession>(job.scene, job.settings, ProgressCallback{}, before.get());
    } catch (const std::exception& error) {
        failure = error.what();
        return nullptr;
    }
}

/// Needs the lock. False where there is nothing to render.
bool Renderer::begin(const Session& session, std::string failure) {
    failure_ = std::move(failure);
    if (!session) return false;
    try {
        session->set_paused(paused_);
        session->start();
        current_ = true;
    } catch (const std::exception& error) {  // no thread to be had
        failure_ = error.what();
    }
    return current_;
}

Renderer::Session Renderer::wait_for_session() {
    std::string failure;
    {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, kPatience, [this] { return current_ || !failure_.empty(); });
        if (current_) return session_;
        failure = std::exchange(failure_, {});
    }
    if (!failure.empty()) fail(failure);
    return nullptr;
}

std::optional<RenderView> Renderer::fresh_view() {
    if (finished_) return std::nullopt;
    const Session session = wait_for_session();
    if (!session) return std::nullopt;
    const bool ended = has_ended(*session);
    RenderView view;
    {
        const std::lock_guard lock(mutex_);
        view.identifiers = identifiers_;
    }
    const bool last = ended && (!identify_ || view.identifiers);
    const std::int64_t passes = session->progress().passes_done;
    const double waited = std::chrono::duration<double>(Clock::now() - shown_at_).count();
    const bool first = shown_passes_ < 0;
    const bool more = passes > std::max<std::int64_t>(shown_passes_, 0);
    const bool due = (more && (first || waited >= kShortestInterval)) || waited >= kLongestInterval;
    if (!last && !due) return std::nullopt;
    view.image = session->snapshot();
    finished_ = last;
    shown_passes_ = passes;
    shown_at_ = Clock::now();
    const std::lock_guard lock(mutex_);
    statistics_ = view.image.statistics;
    return view;
}

Renderer::Status Renderer::status() const {
    const std::lock_guard lock(mutex_);
    Status status;
    if (current_) status.progress = session_->progress();
    status.statistics = statistics_;
    return status;
}

bool Renderer::has_ended(RenderSession& session) {
    if (!session.wait_for(std::chrono::duration<double>(kPatience).count())) return false;
    try {
        session.wait();
    } catch (const std::exception& error) {
        fail(error.what());
    }
    return true;
}

void Renderer::fail(const std::string& why) {
    finished_ = true;
    failed_ = true;
    TF_RUNTIME_ERROR("Etendue: %s", why.c_str());
}

}  // namespace etendue::hydra
