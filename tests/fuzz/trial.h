#pragma once

#include <optional>
#include <string>

#include <etendue/render_settings.h>
#include <etendue/scene_description.h>

#include "fuzz/dice.h"

namespace etendue::test {

/// A random scene, how to render it, and what is known of the picture.
struct Trial {
    SceneDescription scene;
    RenderSettings settings;
    bool hostile = false;            ///< holds what is no number: comparisons with NaN raise what is trapped elsewhere
    std::optional<double> radiance;  ///< of every pixel, where a closed form is known
};

/// Names of prims begin with it; errors that the scene is to blame for must have one.
inline constexpr const char* kPrimPrefix = "/fuzz/";

/// `texture_file`: an image that materials, domes and rect lights may use.
[[nodiscard]] Trial random_trial(Dice& dice, const std::string& texture_file);

/// The same scene with something in it changed: for a session that takes over.
void edit(Dice& dice, SceneDescription& scene);

}  // namespace etendue::test
