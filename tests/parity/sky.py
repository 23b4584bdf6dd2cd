"""The image for the sky of latlong_sky.usda."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from parity.plain_scene import Floats
from support.hdr_file import write_hdr

WIDTH, HEIGHT = 512, 256


def write_sky(file: Path) -> None:
    """A soft sun in a sky that differs in every direction, as a Radiance file.

    Smooth and large: where renderers put the centres of its texels must not matter.
    """
    x, y, z = np.moveaxis(latlong_directions(), -1, 0)
    sun = np.exp(40 * (0.48 * x + 0.64 * y + 0.6 * z - 1))
    red = 0.4 + 0.3 * x + 12 * sun
    green = 0.4 + 0.3 * y * y + 10 * sun
    blue = 0.6 + 0.3 * z + 7 * sun
    write_hdr(file, np.stack([red, green, blue], axis=-1))


def latlong_directions() -> Floats:
    """Of the texels' centres, (h, w, 3): OpenEXR's convention, +z in the middle, +x left of it."""
    longitude = np.pi * (1 - (2 * np.arange(WIDTH) + 1) / WIDTH)[None, :]
    latitude = np.pi / 2 * (1 - (2 * np.arange(HEIGHT) + 1) / HEIGHT)[:, None]
    return np.stack(
        [
            np.cos(latitude) * np.sin(longitude),
            np.sin(latitude) + 0 * longitude,
            np.cos(latitude) * np.cos(longitude),
        ],
        axis=-1,
    )
