#include <etendue/render_session.h>

#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include <pybind11/stl.h>

#include "bindings.h"

namespace py = pybind11;

namespace etendue::python {
namespace {

/// The Python callable behind a ProgressCallback. Its first exception cancels the render and is kept for wait() to
/// raise; the render thread never sees it. Created, called and destroyed from any thread.
class ProgressRelay {
public:
    explicit ProgressRelay(py::function callable) : callable_(std::move(callable)) {}
    ProgressRelay(const ProgressRelay&) = delete;
    ProgressRelay& operator=(const ProgressRelay&) = delete;
    ~ProgressRelay() {
        const py::gil_scoped_acquire acquire;
        callable_ = py::object();
        error_.reset();
    }

    void attach(RenderSession* session) { session_ = session; }

    void report(const RenderProgress& progress) {
        const py::gil_scoped_acquire acquire;
        if (error_) return;
        try {
            callable_(progress);
        } catch (py::error_already_set& error) {
            error_.emplace(std::move(error));
            if (RenderSession* session = session_.load()) session->cancel();
        }
    }

    /// Throws the callable's exception, once. Needs the GIL.
    void rethrow() {
        if (!error_) return;
        py::error_already_set error = std::move(*error_);
        error_.reset();
        throw error;
    }

private:
    py::object callable_;                         // guarded by the GIL
    std::optional<py::error_already_set> error_;  // guarded by the GIL
    std::atomic<RenderSession*> session_{nullptr};
};

/// A RenderSession that never blocks other Python threads: every call that may wait releases the GIL, the destructor
/// included (the render thread may be waiting for the GIL to report progress).
class Session {
public:
    Session(SceneDescription& scene, const RenderSettings& settings, std::optional<py::function> callback,
            bool spend_scene) {
        ProgressCallback forward;
        if (callback) {
            relay_ = std::make_shared<ProgressRelay>(std::move(*callback));
            forward = [relay = relay_](const RenderProgress& progress) { relay->report(progress); };
        }
        const py::gil_scoped_release release;
        session_ = spend_scene ? std::make_unique<RenderSession>(std::move(scene), settings, std::move(forward))
                               : std::make_unique<RenderSession>(std::as_const(scene), settings, std::move(forward));
        if (relay_) relay_->attach(session_.get());
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session() {
        const py::gil_scoped_release release;
        session_.reset();
        relay_.reset();
    }

    void start() {
        const py::gil_scoped_release release;
        session_->start();
    }

    void cancel() {
        const py::gil_scoped_release release;
        session_->cancel();
    }

    void wait() {
        std::exception_ptr failure;
        {
            const py::gil_scoped_release release;
            try {
                session_->wait();
            } catch (...) {
                failure = std::current_exception();
            }
        }
        if (relay_) relay_->rethrow();
        if (failure) std::rethrow_exception(failure);
    }

    bool wait_for(double seconds) {
        const py::gil_scoped_release release;
        return session_->wait_for(seconds);
    }

    RenderProgress progress() const {
        const py::gil_scoped_release release;
        return session_->progress();
    }

    RenderedImage snapshot() const {
        const py::gil_scoped_release release;
        return session_->snapshot();
    }

    const Requirements& requirements() const { return session_->requirements(); }

    MemoryUse memory_use() const {
        const py::gil_scoped_release release;
        return session_->memory_use();
    }

    std::optional<PickedSurface> pick(double x, double y) const {
        const py::gil_scoped_release release;
        return session_->pick(x, y);
    }

private:
    std::shared_ptr<ProgressRelay> relay_;
    std::unique_ptr<RenderSession> session_;
};

}  // namespace

void bind_render_session(py::module_& module) {
    py::class_<RenderProgress>(module, "RenderProgress")
        .def_readonly("passes_done", &RenderProgress::passes_done)
        .def_readonly("passes_total", &RenderProgress::passes_total)
        .def_readonly("fraction", &RenderProgress::fraction)
        .def_readonly("seconds", &RenderProgress::seconds)
        .def_readonly("error", &RenderProgress::error)
        .def_readonly("finished", &RenderProgress::finished);

    py::class_<PickedSurface>(module, "PickedSurface")
        .def_readonly("shape", &PickedSurface::shape)
        .def_readonly("instance", &PickedSurface::instance)
        .def_readonly("triangle", &PickedSurface::triangle);

    py::class_<Session>(module, "RenderSession")
        .def(py::init<SceneDescription&, const RenderSettings&, std::optional<py::function>, bool>(), py::arg("scene"),
             py::arg("settings"), py::arg("callback") = py::none(), py::arg("spend_scene") = false)
        .def("start", &Session::start)
        .def("cancel", &Session::cancel)
        .def("wait", &Session::wait)
        .def("wait_for", &Session::wait_for, py::arg("seconds"))
        .def_property_readonly("progress", &Session::progress)
        .def("snapshot", &Session::snapshot)
        .def_property_readonly("requirements", &Session::requirements)
        .def_property_readonly("memory_use", &Session::memory_use)
        .def("pick", &Session::pick, py::arg("x"), py::arg("y"));
}

}  // namespace etendue::python
