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

/// sizeFactor of rect, disk, sphere, cylinder (without ends) and mesh: the world-space area, in stage units squared. A
/// proposed change of UsdLux (OpenUSD PR 3587) would make it square metres: here is where to follow it. Of an ellipsoid
/// (a sphere under a transform that is no similarity) the area is exact, not hdEmbree's p = 1.6 approximation, and so
/// is a cylinder's.
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

/// Whether the light emits at all, whatever its size.
[[nodiscard]] bool lux_emits(const LightDesc& light);

/// Whether its own transform says where it is: a mesh light lies where its shape does, infinite ones nowhere.
[[nodiscard]] inline bool lux_has_place(const LightDesc& light) {
    return light.kind != LightKind::Distant && light.kind != LightKind::Dome && light.kind != LightKind::Mesh;
}

/// Whether a sphere is taken as a point, a cylinder as a line: of those no ray finds any.
[[nodiscard]] bool lux_is_thin(const LightDesc& light);

/// The texture that multiplies the radiance of a dome or a rect; none of other lights, nor of one that emits nothing.
/// On a rect, its upper left corner is at (+X, +Y) and its lower right one at (-X, -Y): upright to who sees it shine.
/// (UsdLux says "min" and "max coordinates"; hdEmbree mirrors it.)
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

/// Of a cylinder light taken as a line (treatAsLine, or radius 0) the K of its radiant intensity K sin(theta) per unit
/// of length: that of a thin tube of the same area A and radiance L, K = L A / (pi length), which is 2 r L for a circle
/// and keeps the power. Without an area it is the limit of a normalised one, as for points.
[[nodiscard]] Rgb lux_line_intensity(const LightDesc& light, double world_area, double world_length);

/// ShapingAPI as a factor of the radiance that leaves at the angle `theta` (radians) from the light's -Z in the world:
///
///     focus   lerp(|cos theta|^focus, focusTint, 1), where focus > 0
///     cone    1 - smoothstep(theta, start, angle), start = angle (1 - softness); 0 beyond the angle
///
/// By the absolute value, focus alone leaves light that goes backwards. Components of the tint below zero count as
/// zero.
[[nodiscard]] Rgb lux_shaping(const ShapingDesc& shaping, double theta);

/// The angle beyond which lux_shaping is zero, radians in [0, pi].
[[nodiscard]] double lux_shaping_end(const ShapingDesc& shaping);

}  // namespace etendue
