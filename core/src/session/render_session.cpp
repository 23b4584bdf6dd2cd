#include <etendue/render_session.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "film/film.h"
#include "integrator/integrator.h"
#include "scene/media_probe.h"
#include "scene/off_surfaces.h"
#include "scene/world_origin.h"
#include "session/error_watch.h"
#include "session/pass.h"
#include "session/pilot.h"
#include "session/sample_plan.h"
#include "session/validate_settings.h"
#include "util/asks_for.h"
#include "util/hand_over.h"

namespace etendue {
namespace {

using Clock = std::chrono::steady_clock;

Origins checked_origins(const SceneDescription& scene, const RenderSettings& settings) {
    validate_settings(settings, scene);
    return find_origins(scene, scene.cameras[static_cast<std::size_t>(settings.camera)]);
}

Camera make_camera(const SceneDescription& scene, const RenderSettings& settings, const Vec3& origin) {
    CameraDesc camera = scene.cameras[static_cast<std::size_t>(settings.camera)];
    camera.world_from_camera = relative_to(origin, camera.world_from_camera);
    return Camera(camera, settings.width, settings.height, settings.conform);
}

Camera off_surfaces(const Scene& scene, Camera camera) {
    camera.stand_at(off_surfaces(scene, camera.position()));
    return camera;
}

std::vector<Vec3> lens_points(const Camera& camera) {
    if (!camera.has_lens()) return {};
    return {camera.position()};
}

RenderContext make_context(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                           const Requirements& needs) {
    return {scene,
            camera,
            settings,
            Filter(settings.filter),
            render_window(settings),
            needs.strategies,
            needs.first_surface,
            asks_for(settings, {Aov::Albedo}),
            media_at(scene, camera.position())};
}

int thread_count(const RenderSettings& settings) {
    return settings.threads > 0 ? settings.threads : tbb::task_arena::automatic;
}

/// The same for any number of threads: they sum up fixed parts, which are added up in order.
ErrorEstimate estimate_error(const RelativeError& error, const PixelFilter& filter) {
    constexpr int kRows = 8;
    std::vector<ErrorSums> parts(static_cast<std::size_t>((error.height() + kRows - 1) / kRows));
    HandOver hand_over;
    hand_over.give();
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t part) {
        hand_over.take();
        const int begin = static_cast<int>(part) * kRows;
        parts[part] = error.of_rows(begin, std::min(begin + kRows, error.height()));
        hand_over.give();
    });
    hand_over.take();
    ErrorSums sums;
    for (const ErrorSums& part : parts) sums += part;
    const double reach = std::max(1.0, 2 * filter.radius);
    return sums.estimate(reach * reach);
}

}  // namespace

class RenderSession::Impl {
public:
    /// `spent` is the scene, if it need not be kept.
    Impl(const SceneDescription& scene, const RenderSettings& settings, ProgressCallback callback, const Impl* before,
         SceneDescription* spent)
        : settings_(settings),
          callback_(std::move(callback)),
          origins_(checked_origins(scene, settings_)),
          needs_(find_requirements(scene, settings_)),
          arena_(thread_count(settings_)),
          scene_(scene, lens_points(make_camera(scene, settings_, origins_.world)),
                 {needs_, origins_, settings_.texture_memory, before != nullptr ? &before->scene_ : nullptr, spent}),
          camera_(off_surfaces(scene_, make_camera(scene, settings_, origins_.world))),
          integrator_(make_integrator(make_context(scene_, camera_, settings_, needs_))),
          runner_(std::in_place, *integrator_, render_window(settings_)),
          plan_(runner_->tiles()),
          film_(settings_, render_window(settings_), integrator_->image_strategies()),
          watch_(settings_.error_target) {
        if (settings_.integrator == IntegratorKind::Auto) {
            pilot_camera_ = off_surfaces(scene_, make_camera(scene, pilot_settings(settings_), origins_.world));
        }
    }

    ~Impl() {
        cancel();
        if (thread_.joinable()) thread_.join();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void start() {
        const std::lock_guard lock(state_mutex_);
        if (started_) return;
        begin_ = Clock::now();
        thread_ = std::thread([this] { run(); });  // waits for the lock before it ends
        started_ = true;
    }

    void cancel() noexcept {
        stop_ = true;
        resume_signal_.notify_all();
    }

    void set_paused(bool paused) {
        {
            const std::lock_guard lock(pause_mutex_);
            paused_ = paused;
        }
        resume_signal_.notify_all();
    }

    void wait() {
        std::unique_lock lock(state_mutex_);
        ended_signal_.wait(lock, [this] { return ended_ || !started_; });
        if (failure_) std::rethrow_exception(failure_);
    }

    bool wait_for(double seconds) {
        std::unique_lock lock(state_mutex_);
        return ended_signal_.wait_for(lock, std::chrono::duration<double>(seconds),
                                      [this] { return ended_ || !started_; });
    }

    RenderProgress progress() const {
        RenderProgress p;
        {
            const std::lock_guard lock(state_mutex_);
            p.finished = finished_;
            p.seconds = seconds();
            p.passes_done = passes_done_;
            p.error = watch_.error();
            p.fraction = watch_.fraction(p.passes_done);
        }
        p.passes_total = settings_.samples_per_pixel;
        if (p.passes_total > 0) {
            p.fraction = std::max(p.fraction, static_cast<double>(p.passes_done) / static_cast<double>(p.passes_total));
        }
        if (settings_.time_limit > 0) p.fraction = std::max(p.fraction, p.seconds / settings_.time_limit);
        p.fraction = p.finished ? 1 : std::min(p.fraction, 1.0);
        return p;
    }

    RenderedImage snapshot() const {
        RenderedImage image;
        {
            const std::lock_guard lock(film_mutex_);
            image = film_.image();
        }
        const std::lock_guard lock(state_mutex_);
        image.statistics.seconds = seconds();
        image.statistics.error = watch_.error();
        image.statistics.chosen = chosen_;
        return image;
    }

    [[nodiscard]] const Requirements& requirements() const { return needs_; }

    [[nodiscard]] MemoryUse memory_use() const {
        MemoryUse use = scene_.memory_use();
        const std::lock_guard lock(film_mutex_);
        use.film = film_.memory_used(integrator_->light_paths_per_pass() > 0);
        return use;
    }

    [[nodiscard]] std::optional<PickedSurface> pick(double x, double y) const {
        const CameraRay ray = camera_.generate_ray({x, y}, {0.5, 0.5});
        return scene_.pick({ray.origin, ray.direction});
    }

private:
    /// Needs state_mutex_.
    [[nodiscard]] double seconds() const {
        if (!started_) return 0;
        return std::chrono::duration<double>((finished_ ? end_ : Clock::now()) - begin_).count();
    }

    void run() {
        std::exception_ptr failure;
        try {
            arena_.execute([this] {
                if (pilot_camera_) choose();
                render_passes();
                look_at_error();
            });
        } catch (...) {
            failure = std::current_exception();
        }
        {
            const std::lock_guard lock(state_mutex_);
            finished_ = true;
            end_ = Clock::now();
        }
        try {
            if (callback_) callback_(progress());
        } catch (...) {
            failure = std::current_exception();
        }
        {
            // Only now: whoever waits may take apart what the callback uses.
            const std::lock_guard lock(state_mutex_);
            failure_ = failure;
            ended_ = true;
        }
        ended_signal_.notify_all();
    }

    /// Only the render's own thread knows of the integrator.
    void choose() {
        const ChosenMethod method = choose_method(settings_, scene_, *pilot_camera_, needs_.strategies, stop_);
        chosen_settings_ = settings_;
        chosen_settings_.integrator = method.integrator;
        chosen_settings_.light_paths_per_pixel = method.light_paths_per_pixel;
        runner_.reset();
        {
            const std::lock_guard lock(film_mutex_);  // of memory_use()
            integrator_ = make_integrator(make_context(scene_, camera_, chosen_settings_, needs_));
        }
        runner_.emplace(*integrator_, render_window(settings_));
        const std::lock_guard lock(state_mutex_);
        chosen_ = method;
    }

    void render_passes() {
        for (std::int64_t pass = 0; settings_.samples_per_pixel == 0 || pass < settings_.samples_per_pixel; ++pass) {
            if (places_samples(settings_)) plan_.begin(static_cast<std::uint64_t>(pass), film_);
            if (!runner_->run(static_cast<std::uint64_t>(pass), plan_, stop_, [this](const FilmTile& tile) {
                    take(tile);
                    hold();
                })) {
                return;
            }
            {
                const std::lock_guard lock(film_mutex_);
                film_.end_pass();
            }
            ++passes_done_;
            if (watch_.due(passes_done_)) look_at_error();
            if (callback_) callback_(progress());
            if (watch_.reached()) return;
        }
    }

    /// Between passes: nobody changes the film.
    void look_at_error() {
        if (watch_.looked_at() == passes_done_ || !film_.shows_error()) return;
        const ErrorEstimate estimate = estimate_error(film_.relative_error(), settings_.filter);
        const std::lock_guard lock(state_mutex_);
        watch_.look(passes_done_, estimate);
    }

    /// Waits while paused. Tiles are handed over one by one, so the others soon wait for this one.
    void hold() {
        std::unique_lock lock(pause_mutex_);
        // cancel() notifies without the lock and may come just before the wait: look again after a moment.
        while (paused_ && !stop_) resume_signal_.wait_for(lock, std::chrono::milliseconds(50));
    }

    void take(const FilmTile& tile) {
        const std::lock_guard lock(film_mutex_);
        plan_.count(static_cast<std::uint64_t>(passes_done_), tile);
        film_.add(tile);
        if (settings_.time_limit > 0 && Clock::now() - begin_ >= std::chrono::duration<double>(settings_.time_limit)) {
            stop_ = true;
        }
    }

    RenderSettings settings_;
    ProgressCallback callback_;
    Origins origins_;  ///< from which positions are measured
    Requirements needs_;
    tbb::task_arena arena_;
    Scene scene_;
    Camera camera_;
    std::optional<Camera> pilot_camera_;  ///< only for Auto
    RenderSettings chosen_settings_;      ///< likewise
    std::unique_ptr<Integrator> integrator_;
    std::optional<PassRunner> runner_;
    SamplePlan plan_;
    Film film_;
    ErrorWatch watch_;  ///< changed by the render's thread alone, and then under state_mutex_

    mutable std::mutex film_mutex_;
    std::mutex pause_mutex_;
    std::condition_variable resume_signal_;
    bool paused_ = false;
    mutable std::mutex state_mutex_;
    std::condition_variable ended_signal_;
    std::atomic<bool> stop_{false};
    std::atomic<std::int64_t> passes_done_{0};
    std::optional<ChosenMethod> chosen_;
    bool started_ = false;
    bool finished_ = false;  ///< rendering is
    bool ended_ = false;     ///< and the callback knows
    std::exception_ptr failure_;
    Clock::time_point begin_;
    Clock::time_point end_;
    std::thread thread_;
};

RenderSession::RenderSession(const SceneDescription& scene, const RenderSettings& settings, ProgressCallback callback,
                             const RenderSession* before)
    : impl_(std::make_unique<Impl>(scene, settings, std::move(callback),
                                   before != nullptr ? before->impl_.get() : nullptr, nullptr)) {}
RenderSession::RenderSession(SceneDescription&& scene, const RenderSettings& settings, ProgressCallback callback,
                             const RenderSession* before)
    : impl_(std::make_unique<Impl>(scene, settings, std::move(callback),
                                   before != nullptr ? before->impl_.get() : nullptr, &scene)) {}
RenderSession::~RenderSession() = default;
RenderSession::RenderSession(RenderSession&&) noexcept = default;
RenderSession& RenderSession::operator=(RenderSession&&) noexcept = default;

void RenderSession::start() { impl_->start(); }
void RenderSession::cancel() noexcept { impl_->cancel(); }
void RenderSession::set_paused(bool paused) { impl_->set_paused(paused); }
void RenderSession::wait() { impl_->wait(); }
bool RenderSession::wait_for(double seconds) { return impl_->wait_for(seconds); }
RenderProgress RenderSession::progress() const { return impl_->progress(); }
RenderedImage RenderSession::snapshot() const { return impl_->snapshot(); }
const Requirements& RenderSession::requirements() const { return impl_->requirements(); }
MemoryUse RenderSession::memory_use() const { return impl_->memory_use(); }
std::optional<PickedSurface> RenderSession::pick(double x, double y) const { return impl_->pick(x, y); }

}  // namespace etendue
