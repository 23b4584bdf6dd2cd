#pragma once

#include "light/light.h"
#include "scene/media.h"
#include "scene/scene.h"

namespace etendue {

/// In which bodies a place lies is found by going from it as light would, straight through what lets light pass and
/// scattered by anything else. A body's surface that is first met from the inside says that the place lies in it, one
/// first met from outside that it does not, whichever way it was reached. Of closed bodies all ways say the same; of
/// open ones, such as the water of a pool that is nothing but its surface, the majority knows, and who sees the surface
/// directly knows best. Nobody asks in scenes that absorb nothing: there the answer is empty.

/// The media at a point that is on no surface.
[[nodiscard]] Media media_at(const Scene& scene, const Vec3& p);

/// The media into which a light emits; empty for lights at infinity and dark ones.
[[nodiscard]] Media media_before(const Scene& scene, const Light& light);

}  // namespace etendue
