"""The Blender add-on: its pictures, its settings, and its comings and goings."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import OpenEXR
import pytest
from pxr import Usd, UsdLux

import etendue
from support.hydra_host import HydraHost
from support.path_order import open_in_path_order
from support.same_picture import assert_same_picture, read_color, rgb

ADDONS = Path(__file__).resolve().parents[2] / "plugin" / "blender"
ENVIRONMENT = {"ETENDUE_BLENDER_ADDONS": str(ADDONS)}
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
    host.run("blender_scene", *arguments, environment=ENVIRONMENT)
    ours = read_color(picture)
    stage = open_in_path_order(exported)
    if method == "HYDRA":
        without_temperatures(stage)
    size = (ours.shape[1], ours.shape[0])
    assert_same_picture(ours, rgb(etendue.open(stage).render(spp=SAMPLES, resolution=size)))


def layers(file: Path) -> dict[str, np.ndarray]:
    """All channels of all parts of an .exr, by name."""
    with OpenEXR.File(str(file)) as picture:
        parts = [part.channels for part in picture.parts]
        return {name: found.pixels for part in parts for name, found in part.items()}


def test_a_scene_behind_the_window_has_its_own_settings(host: HydraHost, tmp_path: Path) -> None:
    behind, shown = tmp_path / "behind.exr", tmp_path / "shown.exr"
    host.run("blender_two_scenes", SAMPLES, behind, shown, environment=ENVIRONMENT)
    ours, expected = layers(behind), layers(shown)
    assert ours.keys() == expected.keys()
    assert np.abs(ours["ViewLayer.Normal.Z"]).mean() > 0.1
    for name, values in ours.items():
        np.testing.assert_array_equal(values, expected[name])


def test_the_add_on_comes_and_goes(host: HydraHost) -> None:
    nothing, everything = str([False] * 4), str([True] * 4)
    said = host.run("blender_register", environment=ENVIRONMENT).splitlines()
    assert said == [nothing, *[everything, nothing] * 2]


def test_the_extension_can_be_packaged_and_installed(host: HydraHost, tmp_path: Path) -> None:
    source, user = tmp_path / "source", tmp_path / "user"
    without_plugin = shutil.ignore_patterns("usd", "__pycache__")
    shutil.copytree(ADDONS / "etendue_hydra", source, ignore=without_plugin)
    shutil.copytree(host.plugin.parents[1], source / "usd")
    environment = {"BLENDER_USER_RESOURCES": str(user)}
    said = host.run("blender_extension", source, tmp_path, environment=environment)
    installed = user / "extensions/user_default/etendue_hydra"
    assert said.splitlines()[-1] == str(installed / "usd/hdEtendue/resources")
