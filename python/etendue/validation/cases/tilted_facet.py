"""stages/facet.usda: a square whose shading normals lean, under a sun."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, pi, radians, sin

import numpy as np

from etendue.arrays import FloatArray
from etendue.validation.shots import Shot

N_G = (0.0, 1.0, 0.0)
ILLUMINANCE = 3.0
MATTE = 0.8
#: Of the Phong materials.
REFLECTANCE, EXPONENT = 0.8, 4.0
#: Width of the view for a camera straight above; the facet is 1 m wide.
VIEW = 0.9


def direction(degrees: float) -> FloatArray:
    """From the facet's own normal towards +X."""
    return np.array([sin(radians(degrees)), cos(radians(degrees)), 0.0])


def facet_shot(integrator: str, material: str, tilt: float, sun: float, view: float) -> Shot:
    """Direct light on the facet, which fills the view. Angles in degrees."""
    normal = tuple(float(x) for x in direction(tilt))
    # Tenths of a metre across parallel rays; foreshortened, so that all of it stays on the facet.
    aperture = 10 * VIEW * cos(radians(view))
    return Shot(
        stage="facet.usda",
        camera="/cameras/arm/main",
        integrator=integrator,
        resolution=(4, 4),
        max_depth=1,
        variants={"/World{material}": material},
        values={
            "/World/Facet.normals": (normal,) * 4,
            "/Lights/Arm.xformOp:rotateZ": -sun,
            "/cameras/arm.xformOp:rotateZ": -view,
            "/cameras/arm/main.horizontalAperture": aperture,
            "/cameras/arm/main.verticalAperture": aperture,
        },
    )


def matte_radiance(tilt: float, sun: float) -> float:
    """The same from everywhere."""
    return MATTE / pi * ILLUMINANCE * float(direction(sun) @ direction(tilt))


def phong_radiance(form: str, sun: float, view: float) -> float:
    """theory.md §7, without a tilt."""
    lobe = float(np.maximum(0.0, cos(radians(sun + view))) ** EXPONENT)
    if form == "classic":
        return REFLECTANCE * (EXPONENT + 1) / (2 * pi) * lobe * ILLUMINANCE
    return REFLECTANCE * (EXPONENT + 2) / (2 * pi) * lobe * ILLUMINANCE * cos(radians(sun))


def spread(first: float, last: float, count: int) -> Sequence[float]:
    """Angles, both ends included."""
    return [float(angle) for angle in np.linspace(first, last, count)]
