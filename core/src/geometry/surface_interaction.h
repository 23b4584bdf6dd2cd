#pragma once

#include "math/vec.h"

namespace etendue {

/// Where a ray met a surface; world space.
struct SurfaceInteraction {
    Vec3 p;
    Vec3 p_error;  ///< per axis, bounds how far p and Embree's float surface may lie apart
    Vec3 n_g;      ///< outward geometric normal, never flipped towards the ray
    Vec3 n_s;      ///< shading normal before normal mapping, on the side of n_g as authored
    Vec3 dpds;     ///< tangents along the texture coordinates; zero without texture coordinates
    Vec3 dpdt;
    Vec2 st;
    int material = -1;  ///< index into the scene's materials
    int light = -1;     ///< index into the scene's lights when the surface emits
};

}  // namespace etendue
