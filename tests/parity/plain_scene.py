"""A scene that any renderer can be told: world space, plain arrays, nothing of USD or Etendue.

Lengths are scene units, radiance and reflectance linear Rec.709. Instances can be pickled.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Floats: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]
Rgb: TypeAlias = tuple[float, float, float]


@dataclass(frozen=True)
class Diffuse:
    """Lambert on both sides."""

    reflectance: Rgb


@dataclass(frozen=True)
class Dielectric:
    """Index `ior` against the geometric normal, 1 outside. GGX of this alpha; 0 is smooth."""

    ior: float
    alpha: float


Material: TypeAlias = Diffuse | Dielectric


@dataclass(frozen=True)
class Mesh:
    """Triangles; counter-clockwise seen from outside."""

    name: str
    corners: Floats  #: (n, 3, 3)
    normals: Floats | None  #: (n, 3, 3), or flat
    material: Material


@dataclass(frozen=True)
class Ball:
    """An exact sphere."""

    name: str
    centre: Floats
    radius: float
    material: Material


@dataclass(frozen=True)
class RectLamp:
    """Emits along -z of its space; black and opaque otherwise, as all lamps are."""

    name: str
    world_from_light: Floats  #: (4, 4), for column vectors
    width: float
    height: float
    radiance: Rgb


@dataclass(frozen=True)
class DiskLamp:
    """Emits along -z of its space."""

    name: str
    world_from_light: Floats
    radius: float
    radiance: Rgb


@dataclass(frozen=True)
class SphereLamp:
    """Emits outwards."""

    name: str
    centre: Floats
    radius: float
    radiance: Rgb


@dataclass(frozen=True)
class Sky:
    """The same radiance from everywhere."""

    radiance: Rgb


@dataclass(frozen=True)
class LatlongSky:
    """An image around the scene: OpenEXR's latlong convention in the space of the light."""

    world_from_light: Floats
    file: str
    scale: Rgb


Lamp: TypeAlias = RectLamp | DiskLamp | SphereLamp
Surroundings: TypeAlias = Sky | LatlongSky


@dataclass(frozen=True)
class Camera:
    """A pinhole. The image fills `window` of the plane at distance 1, row 0 on top."""

    position: Floats
    right: Floats
    up: Floats
    forward: Floats
    window: tuple[float, float, float, float]  #: left, right, bottom, top


@dataclass(frozen=True)
class Scene:
    """All of it."""

    meshes: tuple[Mesh, ...]
    balls: tuple[Ball, ...]
    lamps: tuple[Lamp, ...]
    surroundings: tuple[Surroundings, ...]
    camera: Camera
