"""A scene made in Blender, through our engine and through Blender's own export to USD."""

from __future__ import annotations

from pathlib import Path

import pytest
from pxr import Usd, UsdLux

import etendue
from support.hydra_host import HydraHost
from support.path_order import open_in_path_order
from support.same_picture import assert_same_picture, read_color, rgb

ADDONS = Path(__file__).resolve().parents[2] / "plugin" / "blender"
SAMPLES = 8


def without_temperatures(stage: Usd.Stage) -> Usd.Stage:
    """Blender 5.0 exports lights with a colour temperature of 6500 K, which in UsdLux is not white,
    and does not tell Hydra so.
    """
    for prim in stage.Traverse():
        if prim.HasAPI(UsdLux.LightAPI):
            UsdLux.LightAPI(prim).GetEnableColorTemperatureAttr().Set(False)
    return stage


@pytest.mark.parametrize("method", ["HYDRA", "USD"])
def test_the_engine_renders_what_blender_exports(
    host: HydraHost, tmp_path: Path, method: str
) -> None:
    picture, exported = tmp_path / "picture.exr", tmp_path / "scene.usda"
    arguments = (method, SAMPLES, picture, exported)
    host.run("blender_scene", *arguments, environment={"ETENDUE_BLENDER_ADDONS": str(ADDONS)})
    ours = read_color(picture)
    stage = open_in_path_order(exported)
    if method == "HYDRA":
        without_temperatures(stage)
    size = (ours.shape[1], ours.shape[0])
    assert_same_picture(ours, rgb(etendue.open(stage).render(spp=SAMPLES, resolution=size)))
