#pragma once

#include <cstdint>

#include <etendue/render_settings.h>

#include "camera/camera.h"
#include "film/filter.h"
#include "scene/scene.h"

namespace etendue {

/// What every integrator needs; outlives the render.
struct RenderContext {
    const Scene& scene;
    const Camera& camera;
    const RenderSettings& settings;
    Filter filter;
    PixelWindow window;      ///< pixels to render, within the full image
    StrategySet strategies;  ///< that can carry light here (Requirements)
    bool wants_surface;      ///< an AOV describes the first surface
    bool wants_albedo;
    Media camera_media{};  ///< what the camera lies in; one for all of its lens, or of its plane
};

/// A share of a pass: so many samples for each pixel of the tile, and some of the pass's light paths.
struct WorkUnit {
    PixelWindow tile;
    std::uint64_t pass = 0;
    std::uint64_t first_sample = 0;  ///< number of the first one among those that the replicate takes of the pixel
    std::uint64_t samples = 1;
    std::uint64_t light_begin = 0;  ///< numbers of light paths within the pass
    std::uint64_t light_end = 0;
};

}  // namespace etendue
