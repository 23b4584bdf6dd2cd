"""stages/crossings.usda: glass between a sun and a matte plate."""

from __future__ import annotations

from math import cos, pi, radians

from etendue.validation.predictions import crossing_ratio, floor_irradiance
from etendue.validation.shots import Shot

REFRACTION = "refraction"
WATER = 1.333
#: What particles scaled like radiance are multiplied by when they enter water.
INTO_WATER = crossing_ratio(1, WATER)
ETAS = (1.1, 1.333, 1.5, 2.42)
#: The stage's variants, as people read them.
CROSSINGS = {"enter": "entering", "leave": "leaving", "slab": "slab"}
#: Of those with one crossing, wrong / right.
FORMULAS = {"enter": "η²", "leave": "η⁻²"}

_ILLUMINANCE = 3.0
_REFLECTANCE = 0.5
_GLASS = "/World/Materials/Glass/Surface.inputs"


def crossing_shot(
    crossing: str,
    integrator: str,
    *,
    eta: float = 1.5,
    angle: float = 0.0,
    roughness: float = 0.0,
    sun_size: float = 0.0,
    strategy_images: int = 0,
) -> Shot:
    """Direct light alone. The sun's zenith angle and angular size are in degrees."""
    values: dict[str, object] = {
        f"{_GLASS}:specular_ior": eta,
        "/Lights/Arm.xformOp:rotateZ": -angle,
    }
    if roughness:
        values[f"{_GLASS}:specular_roughness"] = roughness
    if sun_size:
        values["/Lights/Arm/Sun.inputs:angle"] = sun_size
    return Shot(
        stage="crossings.usda",
        camera="/cameras/meter",
        integrator=integrator,
        resolution=(8, 8),
        max_depth=3 if crossing == "slab" else 2,  # the surfaces, the plate
        variants={"/World{crossing}": crossing},
        values=values,
        strategy_images=strategy_images,
    )


def plate(angle: float, eta: float) -> float:
    """Radiance that the plate shows behind one smooth surface; eta: the far side over the near."""
    return _REFLECTANCE / pi * floor_irradiance(_ILLUMINANCE, cos(radians(angle)), eta)
