#pragma once

#include <cstdint>

#include <etendue/render_settings.h>

namespace etendue {

/// Which strategies take part, as factors in the weights, after scene, camera and settings have had their say.
struct ActiveStrategies {
    bool emission_hit = false;
    bool direct_light = false;
    bool connection = false;
    bool light_image = false;
    bool lens_hit = false;
    /// Light subpaths in a pass, for one camera sample per pixel: the number of samples of strategies t <= 1.
    double light_paths = 0;

    [[nodiscard]] bool needs_light_paths() const { return connection || light_image || lens_hit; }
    [[nodiscard]] bool needs_camera_paths() const { return emission_hit || direct_light || connection; }
};

}  // namespace etendue
