#pragma once

#include <optional>

#include <etendue/scene_description.h>

#include "math/frame.h"
#include "math/rgb.h"
#include "math/transform.h"

namespace etendue {

/// What the attributes of a UsdLux light mean (UsdLux 26.11), in one place:
///
///     L  = intensity 2^exposure [/ sizeFactor when normalize]
///     Lc = L color [temperature tint]
///
/// A component of `color` below zero (outside the gamut of the rendering space) counts as zero: no light is negative.

/// Radiance, nits, of a light whose sizeFactor is `size_factor`; it is ignored unless the light is normalised.
[[nodiscard]] Rgb lux_radiance(const LightDesc& light, double size_factor);

/// sizeFactor of rect, disk, sphere and mesh: the world-space area, in stage units squared. A proposed change of
/// UsdLux (OpenUSD PR 3587) would make it square metres: here is where to follow it. Of an ellipsoid (a sphere under a
/// transform that is no similarity) the area is exact, not hdEmbree's p = 1.6 approximation.
[[nodiscard]] double lux_area_size_factor(double world_area);

/// Half the authored full angle of a distant light, radians, clamped to [0, pi].
[[nodiscard]] double lux_distant_half_angle(const LightDesc& light);

/// sizeFactor of a distant light: 1 for t = 0, pi sin^2 t up to a hemisphere, pi (2 - sin^2 t) beyond. Up to a
/// hemisphere that is the irradiance of unit radiance on a facing surface, so that a normalised light gives
/// `intensity` lux.
[[nodiscard]] double lux_distant_size_factor(double half_angle);

/// Irradiance, lux, on a facing surface of a distant light of angle 0, which is a delta: its sizeFactor is 1 whether
/// normalised or not, so `intensity` is lux. An un-normalised default sun (50000) is therefore 3.36 lux at angle 0.53
/// but 50000 lux at angle 0.
[[nodiscard]] Rgb lux_delta_distant_irradiance(const LightDesc& light);

/// A dome ignores `normalize`: its sizeFactor is 1. A texture multiplies its radiance.
[[nodiscard]] Rgb lux_dome_radiance(const LightDesc& light);

/// The texture that multiplies the radiance of a dome; none of other lights.
[[nodiscard]] std::optional<TextureDesc> lux_texture(const LightDesc& light);

/// The axes of a dome's latlong texture, in the world (LatlongDomeLight). Of light space, the texture's top is +Y and
/// its middle +Z; with pole axis Z, which is the rotation by 90 degrees about +X, they are +Z and -Y. Scales and shears
/// of the transform, which mean nothing at infinity, are left out: the pole keeps its direction, the middle is made
/// perpendicular to it. Mirroring is kept.
[[nodiscard]] Frame lux_dome_frame(const LightDesc& light, const Transform& world_from_light);

/// Luminous intensity, candela in stage units (E = I / d^2), of a sphere light taken as a point. UsdLux gives no rule.
/// - treatAsPoint with a radius keeps the far field: a convex body of area A and radiance L has the mean projected
///   area A/4 (Cauchy), so I = L A / 4, which is L pi r^2 for a sphere.
/// - Normalised, L = intensity / A and I = intensity / 4 at any radius. A sphere of radius 0 is that limit, whether
///   normalised or not: un-normalised it would be dark, which no one who authored it meant.
[[nodiscard]] Rgb lux_point_intensity(const LightDesc& light, double world_area);

}  // namespace etendue
