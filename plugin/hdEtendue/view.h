#pragma once

#include <optional>

#include <pxr/base/gf/matrix4d.h>
#include <pxr/imaging/hd/renderPassState.h>

#include <etendue/render_settings.h>
#include <etendue/scene_description.h>

#include "usd.h"

namespace etendue::hydra {

/// What a render pass looks at and where its pixels go.
struct View {
    CameraDesc camera;
    int width = 0;  ///< of the full image
    int height = 0;
    PixelWindow window;  ///< rendered pixels of the full image
    int buffer_x = 0;    ///< where in the render buffers the window begins, row 0 on top
    int buffer_y = 0;
    ApertureConform conform = ApertureConform::ExpandAperture;
    GfMatrix4d world_to_view{1.0};
    GfMatrix4d projection{1.0};

    /// Whether there is anything to render.
    [[nodiscard]] bool is_empty() const { return window.x0 >= window.x1 || window.y0 >= window.y1; }
};

/// Same picture; all of the view is compared.
[[nodiscard]] bool operator==(const View& a, const View& b);

[[nodiscard]] View read_view(const HdRenderPassState& state);

}  // namespace etendue::hydra
