#include "renderer.h"

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
        if (built_) built_->session.cancel();
        waiting_ = std::move(job);
        ++request_;
        current_ = false;
        failure_.clear();
        statistics_ = {};
    }
    finished_ = false;
    shown_passes_ = -1;
    shown_at_ = Clock::now();
    changed_.notify_all();
}

void Renderer::stop(bool wait) {
    std::shared_ptr<Build> ended;
    {
        std::unique_lock lock(mutex_);
        if (built_) built_->session.cancel();
        waiting_.reset();
        ++request_;
        current_ = false;
        failure_.clear();
        statistics_ = {};
        finished_ = true;
        if (wait) changed_.wait(lock, [this] { return !building_; });
        ended = built_;
    }
    while (wait && ended && !ended->session.wait_for(1)) {
    }
}

void Renderer::forget() {
    const std::lock_guard lock(mutex_);
    rebuild_ = true;
}

void Renderer::set_paused(bool paused) {
    const std::lock_guard lock(mutex_);
    paused_ = paused;
    if (built_) built_->session.set_paused(paused);
}

void Renderer::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return quit_ || waiting_; });
        if (quit_) return;
        const RenderJob job = std::move(*waiting_);
        waiting_.reset();
        building_ = true;
        const std::uint64_t request = request_;
        if (std::exchange(rebuild_, false)) built_.reset();
        std::shared_ptr<Build> before = built_;
        lock.unlock();
        std::string failure;
        std::shared_ptr<Build> next = build(job, before.get(), failure);
        lock.lock();
        if (next) built_ = next;
        if (request == request_) begin(std::move(next), std::move(failure));
        building_ = false;
        changed_.notify_all();
        lock.unlock();
        before.reset();  // without the lock: it waits for the render's threads
        lock.lock();
    }
}

/// Null, and why, where there is nothing to render.
std::shared_ptr<Renderer::Build> Renderer::build(const RenderJob& job, const Build* before,
                                                 std::string& failure) const {
    try {
        auto next = std::make_shared<Build>(
            Build{{job.scene, job.settings, {}, before == nullptr ? nullptr : &before->session}, nullptr});
        if (job.identify) {
            next->identifiers =
                std::make_shared<const Identifiers>(identify(next->session, *job.settings.crop, job.prims));
        }
        return next;
    } catch (const std::exception& error) {
        failure = error.what();
        return nullptr;
    }
}

/// Needs the lock.
void Renderer::begin(std::shared_ptr<Build> next, std::string failure) {
    failure_ = std::move(failure);
    if (!next) return;
    try {
        next->session.set_paused(paused_);
        next->session.start();
        current_ = true;
    } catch (const std::exception& error) {  // no thread to be had
        failure_ = error.what();
    }
}

std::shared_ptr<Renderer::Build> Renderer::wait_for_build() {
    std::string failure;
    {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, kPatience, [this] { return current_ || !failure_.empty(); });
        if (current_) return built_;
        failure = std::exchange(failure_, {});
    }
    if (!failure.empty()) fail(failure);
    return nullptr;
}

std::optional<RenderView> Renderer::fresh_view() {
    if (finished_) return std::nullopt;
    const std::shared_ptr<Build> build = wait_for_build();
    if (!build) return std::nullopt;
    const bool last = has_ended(build->session);
    const std::int64_t passes = build->session.progress().passes_done;
    const double waited = std::chrono::duration<double>(Clock::now() - shown_at_).count();
    const bool due = (passes > shown_passes_ && waited >= kShortestInterval) || waited >= kLongestInterval;
    if (!last && !due) return std::nullopt;
    RenderView view{build->session.snapshot(), build->identifiers};
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
    if (current_) status.progress = built_->session.progress();
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
    TF_RUNTIME_ERROR("Etendue: %s", why.c_str());
}

}  // namespace etendue::hydra
