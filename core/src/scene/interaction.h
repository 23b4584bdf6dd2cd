#pragma once

#include "accel/embree_accel.h"
#include "geometry/surface_interaction.h"

namespace etendue {

/// Geometry of a hit on a shape of the top level, or in a group's space: everything but material and light.
[[nodiscard]] SurfaceInteraction interact(const PlacedGeometry& geometry, const Ray& ray, const AccelHit& hit);

/// Which of the shape's material slots was hit.
[[nodiscard]] int hit_slot(const PlacedGeometry& geometry, const AccelHit& hit);

/// Carries an interaction from the group's space to the world.
void to_world(const Transform& world_from_group, SurfaceInteraction& si);

}  // namespace etendue
