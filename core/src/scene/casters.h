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

/// Adds the sphere around the parts of the shape whose materials focus, if there are any; `focusing` is by material.
void add_caster(const PlacedShape& shape, const std::vector<bool>& focusing, const Transform& world_from_parent,
                std::vector<Sphere>& casters);

/// At most `count` spheres that hold all of `spheres`, and fewer where one is no larger than two.
[[nodiscard]] std::vector<Sphere> cluster(std::vector<Sphere> spheres, std::size_t count);

}  // namespace etendue
