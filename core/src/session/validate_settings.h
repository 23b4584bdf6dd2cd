#pragma once

#include <etendue/render_settings.h>
#include <etendue/scene_description.h>

namespace etendue {

/// Throws SettingsError or SceneError when the settings cannot be used with the scene.
void validate_settings(const RenderSettings& settings, const SceneDescription& scene);

/// The pixels to render: the crop, or the whole image.
[[nodiscard]] PixelWindow render_window(const RenderSettings& settings);

}  // namespace etendue
