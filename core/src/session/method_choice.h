#pragma once

#include <functional>

#include <etendue/render_settings.h>

namespace etendue {

/// What a method costs: relMSE of a picture times the work it takes, which is the same however long it is rendered.
/// Infinite for one that must not be chosen. May be asked again about a method, and then says it a little better.
using MethodCost = std::function<double(const ChosenMethod&)>;

/// Light paths per pixel and pass that it may choose.
inline constexpr double kFewestLightPaths = 0.25;
inline constexpr double kMostLightPaths = 32;

/// The cheapest of path, and bdpt with a power of two of light paths, `most` at most. Of bdpt's subsets of strategies
/// only path, which does without light paths, has ever been better by more than a tenth on a stage
/// (tests/auto/README.md); `light` sees nothing in or through glass, and is hardly cheaper than bdpt with many of them.
[[nodiscard]] ChosenMethod choose_method(const MethodCost& cost, double most = kMostLightPaths);

}  // namespace etendue
