"""Which way a dome's image faces, from the stage to the picture."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from pxr import Gf, Sdf, Usd, UsdGeom

import etendue
from support.hdr_file import write_hdr
from support.stage_builder import StageBuilder

STAGES = Path(__file__).parents[2] / "stages"
WIDTH, HEIGHT = 36, 18
SUN = (7, 4)  # column, row
SUN_RADIANCE = 1024.0


def sun_direction(pole: str) -> Gf.Vec3d:
    """By OpenEXR's convention: longitude falls from 180 degrees at the left edge."""
    longitude = math.pi - 2 * math.pi * (SUN[0] + 0.5) / WIDTH
    latitude = math.pi / 2 - math.pi * (SUN[1] + 0.5) / HEIGHT
    east = math.sin(longitude) * math.cos(latitude)
    north = math.cos(longitude) * math.cos(latitude)
    up = math.sin(latitude)
    return Gf.Vec3d(east, up, north) if pole == "Y" else Gf.Vec3d(east, -north, up)


def render_towards(stage: Usd.Stage, direction: Gf.Vec3d) -> float:
    """Radiance in the middle of a view of a tenth of a degree."""
    camera = UsdGeom.Camera.Define(stage, "/Camera")
    camera.CreateHorizontalApertureAttr(0.05)
    camera.CreateVerticalApertureAttr(0.05)
    view = Gf.Matrix4d().SetLookAt(Gf.Vec3d(0), direction, Gf.Vec3d(0.1, 0.2, 0.9))
    camera.AddTransformOp().Set(view.GetInverse())
    image = etendue.open(stage).render(
        resolution=(1, 1), spp=16, camera="/Camera", integrator="path"
    )
    return float(image["color"][0, 0, 0])


@pytest.mark.parametrize(
    ("kind", "up", "turned", "pole"),
    [
        ("DomeLight", "Y", False, "Y"),
        ("DomeLight", "Z", False, "Y"),
        ("DomeLight_1", "Z", False, "Z"),
        ("DomeLight_1", "Z", True, "Z"),
        ("DomeLight", "Y", True, "Y"),
    ],
)
def test_the_sun_is_where_the_image_has_it(
    build: StageBuilder, tmp_path: Path, kind: str, up: str, turned: bool, pole: str
) -> None:
    image = np.full((HEIGHT, WIDTH, 3), 0.5)
    image[SUN[1], SUN[0]] = SUN_RADIANCE
    write_hdr(tmp_path / "sky.hdr", image)
    UsdGeom.SetStageUpAxis(build.stage, up)
    dome = build.light(kind, intensity=2.0)
    dome.GetAttribute("inputs:texture:file").Set(Sdf.AssetPath(str(tmp_path / "sky.hdr")))
    direction = sun_direction(pole)
    if turned:
        UsdGeom.Xformable(dome).AddRotateXYZOp().Set((20, -50, 70))
        turn = UsdGeom.Xformable(dome).ComputeLocalToWorldTransform(0)
        direction = turn.TransformDir(direction)
    # The filter falls by less than 5 % in the twentieth of a texel that the view covers.
    assert render_towards(build.stage, direction) == pytest.approx(2 * SUN_RADIANCE, rel=0.05)


def test_the_sundials_shadow_ends_at_its_pebble() -> None:
    """The texel of the sun is 5 degrees wide: half the shadow's length is in full shade."""
    image = etendue.open(STAGES / "sundial.usda").render(
        camera="/cameras/top", resolution=(240, 180), spp=16, integrator="path", max_depth=1
    )["color"][..., 1]

    def ground(x: float, z: float) -> float:
        scale = 240 * 0.45 / 0.36 / 6  # pixels per unit
        column, row = 120 + x * scale, 90 + z * scale
        return float(image[int(row) - 1 : int(row) + 1, int(column) - 1 : int(column) + 1].mean())

    lit = np.mean([ground(0.7, 0.36), ground(-0.7, 0.36), ground(0.7, -0.36)])
    assert ground(-0.35, -0.182) < 0.5 * lit
    assert ground(-1.9, -0.99) == pytest.approx(lit, rel=0.2)  # beyond its end
