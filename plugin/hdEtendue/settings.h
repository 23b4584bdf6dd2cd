#pragma once

#include <string>

#include <pxr/imaging/hd/renderDelegate.h>

#include <etendue/render_settings.h>

#include "usd.h"

namespace etendue::hydra {

/// What hosts show to users, with the defaults that environment variables may change: usdrecord and others have no
/// place for a renderer's settings.
[[nodiscard]] HdRenderSettingDescriptorList setting_descriptors();

/// The .exr that a finished picture is written to, with all AOVs of core; empty: none. Hosts such as usdrecord write
/// colour alone.
[[nodiscard]] std::string output_file(const HdRenderDelegate& delegate);

/// The settings as the host has them, without what the render pass says (camera, size, AOVs). A value of a wrong kind,
/// or an integrator of an unknown name, is warned about and leaves the default.
[[nodiscard]] RenderSettings render_settings(const HdRenderDelegate& delegate);

}  // namespace etendue::hydra
