"""Who is right where renderers disagree: floors whose radiance is known."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from parity.cases import LUXCORE, MITSUBA_PATH, MITSUBA_PTRACER
from parity.plain_scene import Camera, Diffuse, Floats, LatlongSky, Mesh, Scene
from parity.processes import RendererProcess
from parity.sky import latlong_directions
from parity.tasks import Task
from support.hdr_file import write_hdr
from support.marked_table import Row, table

HEAD = ("floor under a lobe of sky", "exact", "who", "radiance", "wrong by")
REFLECTANCE = 0.5
SPP = 1024
PIXELS = 32


def results_table(work: Path) -> str:
    """Renders and compares."""
    return table(HEAD, _rows(work / "lobe.hdr"))


def _rows(file: Path) -> Iterator[Row]:
    write_hdr(file, np.repeat(_lobe(latlong_directions())[..., None], 3, axis=-1))
    for degrees in (0, 70):
        exact = _floor_radiance()  # turned about the floor's normal, the sky lights it the same
        for method in (MITSUBA_PATH, MITSUBA_PTRACER, LUXCORE):
            scene = _scene(file, degrees)
            task = Task(method, None, scene, PIXELS, PIXELS, max_depth=4)
            with RendererProcess(task) as process:
                radiance = process.render(SPP, 0).image.mean()
            yield (
                f"turned by {degrees}°",
                f"{exact:.4f}",
                str(method),
                f"{radiance:.4f}",
                f"{radiance / exact - 1:+.1%}",
            )


def _lobe(direction: Floats) -> Floats:
    """Radiance of the sky before it is turned; the lobe stands 45 degrees high."""
    radiance: Floats = 0.1 + 10 * np.exp(8 * (direction @ (0.5, np.sqrt(0.5), 0.5) - 1))
    return radiance


def _floor_radiance() -> float:
    """The floor's reflectance over pi times its irradiance, by quadrature in cos^2 and azimuth."""
    steps = 1000
    cos = np.sqrt((np.arange(steps) + 0.5) / steps)[:, None]
    sin = np.sqrt(1 - cos**2)
    phi = 2 * np.pi * (np.arange(steps) + 0.5)[None, :] / steps
    up = np.broadcast_to(cos, (steps, steps))
    direction = np.stack([sin * np.cos(phi), up, sin * np.sin(phi)], axis=-1)
    return float(REFLECTANCE * _lobe(direction).mean())


def _scene(file: Path, degrees: float) -> Scene:
    """A floor of 4 x 4 that fills the picture."""
    points = np.array([(-2.0, 0, 2), (2, 0, 2), (2, 0, -2), (-2, 0, -2)])
    corners = points[[[0, 1, 2], [0, 2, 3]]]
    floor = Mesh("floor", corners, None, Diffuse((REFLECTANCE,) * 3))
    camera = Camera(
        position=np.array([0.0, 8, 0]),
        right=np.array([1.0, 0, 0]),
        up=np.array([0.0, 0, -1]),
        forward=np.array([0.0, -1, 0]),
        window=(-0.15, 0.15, -0.15, 0.15),
    )
    sky = LatlongSky(_turn_about_y(np.radians(degrees)), str(file), (1, 1, 1))
    return Scene((floor,), (), (), (sky,), camera)


def _turn_about_y(angle: float) -> Floats:
    turn = np.eye(4)
    turn[0, 0] = turn[2, 2] = np.cos(angle)
    turn[0, 2] = np.sin(angle)
    turn[2, 0] = -turn[0, 2]
    return turn
