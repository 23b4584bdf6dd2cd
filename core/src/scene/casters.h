#pragma once

#include <cstddef>
#include <vector>

#include <etendue/scene_description.h>

#include "math/sphere.h"
#include "math/transform.h"
#include "scene/placed_shape.h"
#include "texture/texture_set.h"

namespace etendue {

/// What gathers light into caustics: surfaces that send much of it on in narrow bundles.

/// Whether the material is of that kind: by trying it, whatever its model.
[[nodiscard]] bool focuses(const MaterialDesc& material, const TextureSet& textures);

/// Whether it sends any light on in a single direction, if only straight through a hole: likewise.
[[nodiscard]] bool has_delta_lobe(const MaterialDesc& material, const TextureSet& textures);

/// Spheres around those parts of the shapes whose materials focus, in the shapes' space; `focusing` is by material.
[[nodiscard]] std::vector<Sphere> find_casters(const std::vector<PlacedShape>& shapes,
                                               const std::vector<bool>& focusing);

/// A sphere around what the transform makes of this one.
[[nodiscard]] Sphere transformed(const Sphere& sphere, const Transform& transform);

/// At most `count` spheres that hold all of `spheres`, and fewer where one is no larger than two.
[[nodiscard]] std::vector<Sphere> cluster(std::vector<Sphere> spheres, std::size_t count);

}  // namespace etendue
