#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include <etendue/export.h>
#include <etendue/film_view.h>
#include <etendue/picked_surface.h>
#include <etendue/render_settings.h>
#include <etendue/requirements.h>
#include <etendue/scene_description.h>

namespace etendue {

struct RenderProgress {
    std::int64_t passes_done = 0;
    std::int64_t passes_total = 0;  ///< 0 when they are not limited
    /// 0..1, by whichever limit is nearer. For the error's it is a forecast, and may fall: passes done over those that
    /// the last estimate asks for, since squared errors fall like 1 / passes.
    double fraction = 0;
    double seconds = 0;
    double error = std::numeric_limits<double>::infinity();  ///< RenderStatistics::error
    bool finished = false;
};

/// Called from a render thread, never concurrently with itself. Must not throw.
using ProgressCallback = std::function<void(const RenderProgress&)>;

/// Renders one scene progressively in the background. Sessions share nothing: any number may live in a process.
/// All members may be called from any thread; the callback must not call wait().
class ETENDUE_EXPORT RenderSession {
public:
    /// Builds the scene. Throws SceneError, SettingsError, FileError. Takes over from `before`, which may be rendering,
    /// what it has built alike: the same SharedGeometry in the same place, the acceleration structure if all of them
    /// are, and the textures if none has changed (files are not looked at again). The picture is the same without.
    RenderSession(const SceneDescription& scene, const RenderSettings& settings, ProgressCallback callback = {},
                  const RenderSession* before = nullptr);
    /// The same, of a scene that nobody else has a use for: its geometries are let go of as soon as the render has its
    /// own, before the acceleration structure is built, which is when most memory is taken.
    RenderSession(SceneDescription&& scene, const RenderSettings& settings, ProgressCallback callback = {},
                  const RenderSession* before = nullptr);
    /// Cancels and waits.
    ~RenderSession();
    RenderSession(RenderSession&&) noexcept;
    RenderSession& operator=(RenderSession&&) noexcept;

    /// Starts rendering and returns at once. Calling it a second time does nothing.
    void start();
    /// Asks the render to end soon; what has been rendered stays.
    void cancel() noexcept;
    /// Holds rendering, soon, or lets it go on; a held render can be cancelled, and its time limit runs on.
    void set_paused(bool paused);
    /// Returns when rendering has ended; rethrows what ended it early, if anything did.
    void wait();
    /// Waits at most `seconds`; true when rendering has ended.
    [[nodiscard]] bool wait_for(double seconds);

    [[nodiscard]] RenderProgress progress() const;
    /// The picture so far; usable while rendering.
    [[nodiscard]] RenderedImage snapshot() const;

    /// What was derived for the scene and the settings.
    [[nodiscard]] const Requirements& requirements() const;
    [[nodiscard]] MemoryUse memory_use() const;

    /// The nearest surface behind a point of the full image (pixels, row 0 on top, centres at .5), as the middle of the
    /// lens sees it.
    [[nodiscard]] std::optional<PickedSurface> pick(double x, double y) const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace etendue
