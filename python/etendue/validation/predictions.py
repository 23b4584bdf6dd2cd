"""Closed forms of theory.md §5-§7: what a render must show, right and wrong on purpose.

Ratios are wrong over right, of what light subpaths alone carry: pure light tracing, or one strategy
(s, t) unweighted. Under MIS the error is the blend of right and wrong strategies. Directions and
normals are unit 3-vectors; wi points to where light comes from, wo to where it goes. What has no
prediction raises ValueError.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import prod, sqrt

import numpy as np
import numpy.typing as npt


def crossing_ratio(eta_from: float, eta_to: float) -> float:
    """Particles that cross one interface and are scaled like radiance: (eta_to / eta_from)^2.

    theory.md §5. From air into water 1.777; out of it the inverse. Smooth and rough alike.
    """
    if eta_from <= 0 or eta_to <= 0:
        raise ValueError(f"indices of refraction are positive, not {eta_from:g} and {eta_to:g}")
    return (eta_to / eta_from) ** 2


def crossings_ratio(indices: Sequence[float]) -> float:
    """The product of crossing_ratio along the media of a path, in the order light takes them.

    theory.md §5. [1, 1.5, 1], a slab, is 1: wrong code looks right there.
    """
    if not indices:
        raise ValueError("a path lies in at least one medium")
    return prod(crossing_ratio(before, after) for before, after in pairwise(indices))


def shading_normal_ratio(
    n_s: npt.ArrayLike, n_g: npt.ArrayLike, wi: npt.ArrayLike, wo: npt.ArrayLike
) -> float:
    """Particles on a facet with n_s taken for the geometry:
    |wi·n_g| |wo·n_s| / (|wi·n_s| |wo·n_g|).

    theory.md §6. Unbounded towards |wi·n_s| = 0 and |wo·n_g| = 0. ValueError where wi and wo do not
    lie on one side of n_g, or on one side of n_s: there nothing is reflected.
    """
    shading, geometric, to_light, to_eye = (
        np.asarray(vector, dtype=np.float64) for vector in (n_s, n_g, wi, wo)
    )
    light_s, light_g = float(to_light @ shading), float(to_light @ geometric)
    eye_s, eye_g = float(to_eye @ shading), float(to_eye @ geometric)
    sides = {light_s > 0, light_g > 0, eye_s > 0, eye_g > 0}
    if len(sides) > 1 or 0 in (light_s, light_g, eye_s, eye_g):
        raise ValueError("wi and wo lie on different sides of the normals: nothing is reflected")
    return abs(light_g * eye_s / (light_s * eye_g))


def phong_ratio(normal: npt.ArrayLike, wi: npt.ArrayLike, wo: npt.ArrayLike) -> float:
    """Particles scattered by Phong's classic form instead of its adjoint: |wi·N| / |wo·N|.

    theory.md §7. The form divides by the cosine of its first argument, which is where light comes
    from; particles that know wi and sample wo put wo there. The modified form is symmetric: 1.
    """
    axis, to_light, to_eye = (np.asarray(vector, dtype=np.float64) for vector in (normal, wi, wo))
    cos_light, cos_eye = float(to_light @ axis), float(to_eye @ axis)
    if cos_light * cos_eye <= 0:
        raise ValueError("wi and wo lie on different sides of the surface: nothing is reflected")
    return cos_light / cos_eye


def fresnel_reflectance(cos_incidence: float, eta: float) -> float:
    """Of a smooth dielectric for unpolarised light; `eta` is the far side's index over the near
    one's, the cosine is in 0..1. 1 beyond the critical angle."""
    if not 0 <= cos_incidence <= 1 or eta <= 0:
        raise ValueError(f"no reflectance for cosine {cos_incidence:g} and index {eta:g}")
    cos_t_squared = 1 - (1 - cos_incidence**2) / eta**2
    if cos_t_squared <= 0:
        return 1.0
    cos_t = sqrt(cos_t_squared)
    parallel = (eta * cos_incidence - cos_t) / (eta * cos_incidence + cos_t)
    perpendicular = (cos_incidence - eta * cos_t) / (cos_incidence + eta * cos_t)
    return (parallel**2 + perpendicular**2) / 2


def floor_irradiance(normal_irradiance: float, cos_incidence: float, eta: float) -> float:
    """On a level floor under flat clear water, from a distant light: E cos θ (1 - F(θ)).

    theory.md §5. `normal_irradiance` E is that of a surface facing the light, in air; the floor's
    has the same unit. Radiance grows by eta^2 as the cone of light narrows, and every level area
    receives what the water above it takes in, at any depth: no eta^2 is left. Light that the floor
    sends back up and the surface returns is not in it: a black floor, or one bounce.
    """
    return normal_irradiance * cos_incidence * (1 - fresnel_reflectance(cos_incidence, eta))


def floor_irradiance_under_lamp(
    intensity: float, height: float, depth: float, eta: float, radius: npt.ArrayLike
) -> npt.NDArray[np.float64]:
    """The same from a small level lamp of `intensity` straight down, `height` above the water.

    `radius`, of any shape, is the distance from the floor's point below the lamp, which shines
    with the cosine of the angle from straight down. theory.md §5: what leaves the lamp within
    d theta arrives in a ring of the floor, whose radius Snell's law gives; no eta^2 comes in.
    ValueError for points that light reaches from beyond 85 degrees, and for eta below 1.
    """
    if eta < 1:
        raise ValueError(f"the index under a lamp in air is no less than 1, not {eta:g}")
    theta = np.linspace(0.0, np.radians(85.0), 20_001)
    theta_t = np.arcsin(np.sin(theta) / eta)
    ring = height * np.tan(theta) + depth * np.tan(theta_t)
    transmitted = np.array([1 - fresnel_reflectance(float(cos), eta) for cos in np.cos(theta)])
    if np.max(radius) > ring[-1]:
        raise ValueError(f"no prediction farther out than {ring[-1]:g}, at 85 degrees")
    d_ring = np.gradient(ring, theta)
    # sin(theta) / r at the middle, where both are 0, is 1 / (dr / dtheta).
    shrink = np.divide(np.sin(theta), ring, out=1 / d_ring, where=ring > 0)
    values = intensity * np.cos(theta) * transmitted * shrink / d_ring
    irradiance: npt.NDArray[np.float64] = np.interp(np.asarray(radius), ring, values)
    return irradiance
