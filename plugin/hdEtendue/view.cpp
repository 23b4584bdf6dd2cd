#include "view.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <pxr/imaging/hd/camera.h>

#include "convert.h"

namespace etendue::hydra {
namespace {

/// Hydra's apertures and focal lengths are in scene units, CameraDesc's in tenths of them.
constexpr double kTenths = 10;

CameraDesc describe(const HdCamera& camera) {
    CameraDesc desc;
    desc.name = camera.GetId().GetString();
    desc.projection = camera.GetProjection() == HdCamera::Orthographic ? CameraProjection::Orthographic
                                                                       : CameraProjection::Perspective;
    desc.world_from_camera = column_matrix(camera.GetTransform());
    desc.horizontal_aperture = kTenths * camera.GetHorizontalAperture();
    desc.vertical_aperture = kTenths * camera.GetVerticalAperture();
    desc.horizontal_aperture_offset = kTenths * camera.GetHorizontalApertureOffset();
    desc.vertical_aperture_offset = kTenths * camera.GetVerticalApertureOffset();
    desc.focal_length = kTenths * camera.GetFocalLength();
    desc.f_stop = camera.GetFStop();
    desc.focus_distance = camera.GetFocusDistance();
#if PXR_VERSION >= 2505
    desc.exposure_scale = camera.GetLinearExposureScale();
#else
    desc.exposure_scale = std::exp2(camera.GetExposure());
#endif
    return desc;
}

/// A host without a camera prim gives matrices only: a pinhole with the same frustum.
CameraDesc describe(const GfMatrix4d& world_to_view, const GfMatrix4d& projection) {
    CameraDesc desc;
    desc.world_from_camera = column_matrix(world_to_view.GetInverse());
    const bool orthographic = projection[3][3] == 1;
    desc.projection = orthographic ? CameraProjection::Orthographic : CameraProjection::Perspective;
    desc.focal_length = orthographic ? desc.focal_length : kTenths;
    desc.horizontal_aperture = kTenths * 2 / projection[0][0];
    desc.vertical_aperture = kTenths * 2 / projection[1][1];
    const int row = orthographic ? 3 : 2;
    const double sign = orthographic ? -1 : 1;
    desc.horizontal_aperture_offset = sign * projection[row][0] * desc.horizontal_aperture / 2;
    desc.vertical_aperture_offset = sign * projection[row][1] * desc.vertical_aperture / 2;
    return desc;
}

ApertureConform conform_of(CameraUtilConformWindowPolicy policy) {
    switch (policy) {
        case CameraUtilMatchVertically:
            return ApertureConform::AdjustApertureWidth;
        case CameraUtilMatchHorizontally:
            return ApertureConform::AdjustApertureHeight;
        case CameraUtilCrop:
            return ApertureConform::CropAperture;
        case CameraUtilDontConform:
            return ApertureConform::AdjustPixelAspect;
        default:
            return ApertureConform::ExpandAperture;
    }
}

/// Hosts of the older viewport interface leave the framing invalid.
CameraUtilFraming framing_of(const HdRenderPassState& state) {
    if (state.GetFraming().IsValid()) return state.GetFraming();
    const GfVec4f viewport = state.GetViewport();
    return CameraUtilFraming(GfRect2i(GfVec2i(0), static_cast<int>(viewport[2]), static_cast<int>(viewport[3])));
}

/// The display window is the full image; the data window, as far as it lies within, is what is rendered.
void set_windows(const CameraUtilFraming& framing, View& view) {
    const int left = static_cast<int>(std::lround(framing.displayWindow.GetMin()[0]));
    const int top = static_cast<int>(std::lround(framing.displayWindow.GetMin()[1]));
    view.width = static_cast<int>(std::lround(framing.displayWindow.GetMax()[0])) - left;
    view.height = static_cast<int>(std::lround(framing.displayWindow.GetMax()[1])) - top;
    const GfRect2i& data = framing.dataWindow;
    view.window = {std::max(data.GetMinX() - left, 0), std::max(data.GetMinY() - top, 0),
                   std::min(data.GetMaxX() + 1 - left, view.width), std::min(data.GetMaxY() + 1 - top, view.height)};
    view.buffer_x = view.window.x0 + left;
    view.buffer_y = view.window.y0 + top;
}

auto tied(const CameraDesc& c) {
    return std::tie(c.projection, c.world_from_camera.m, c.horizontal_aperture, c.vertical_aperture,
                    c.horizontal_aperture_offset, c.vertical_aperture_offset, c.focal_length, c.f_stop,
                    c.focus_distance, c.exposure_scale);
}

auto tied(const PixelWindow& w) { return std::tie(w.x0, w.y0, w.x1, w.y1); }

}  // namespace

bool operator==(const View& a, const View& b) {
    return tied(a.camera) == tied(b.camera) && tied(a.window) == tied(b.window) && a.width == b.width &&
           a.height == b.height && a.buffer_x == b.buffer_x && a.buffer_y == b.buffer_y && a.conform == b.conform &&
           a.world_to_view == b.world_to_view && a.projection == b.projection;
}

View read_view(const HdRenderPassState& state) {
    View view;
    view.world_to_view = state.GetWorldToViewMatrix();
    view.projection = state.GetProjectionMatrix();
    if (const HdCamera* const camera = state.GetCamera()) {
        view.camera = describe(*camera);
        view.conform = conform_of(state.GetWindowPolicy());
    } else {
        view.camera = describe(view.world_to_view, view.projection);
        view.conform = ApertureConform::AdjustPixelAspect;
    }
    set_windows(framing_of(state), view);
    return view;
}

}  // namespace etendue::hydra
