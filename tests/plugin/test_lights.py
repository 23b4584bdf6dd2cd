"""Lights, through Hydra and through the stage reader."""

from __future__ import annotations

from pathlib import Path

import pytest
from pxr import Gf, UsdGeom, UsdLux, UsdShade

from support.hydra_host import HydraHost
from support.hydra_studio import ENVIRONMENTS, SKY, Studio, assert_parity


@ENVIRONMENTS
@pytest.mark.parametrize(
    ("kind", "attributes"),
    [
        ("DiskLight", {"inputs:radius": 1.0, "inputs:normalize": True}),
        ("SphereLight", {"inputs:radius": 0.3, "inputs:exposure": 1.0}),
        ("SphereLight", {"inputs:radius": 0.3, "treatAsPoint": True}),
        ("CylinderLight", {"inputs:length": 2.0, "inputs:radius": 0.2}),
        ("DistantLight", {"inputs:angle": 5.0, "inputs:intensity": 200.0}),
        ("DomeLight", {"inputs:texture:file": SKY, "inputs:color": Gf.Vec3f(0.5, 0.7, 1.0)}),
        ("DomeLight_1", {"inputs:texture:file": SKY, "poleAxis": "Z"}),
        (
            "RectLight",
            {"inputs:enableColorTemperature": True, "inputs:colorTemperature": 3000.0},
        ),
    ],
)
def test_lights(
    host: HydraHost,
    tmp_path: Path,
    environment: dict[str, str],
    kind: str,
    attributes: dict[str, object],
) -> None:
    studio = Studio()
    light = studio.stage.DefinePrim("/Another", kind)
    light.GetAttribute("inputs:intensity").Set(10.0)
    for name, value in attributes.items():
        light.GetAttribute(name).Set(value)
    UsdGeom.XformCommonAPI(light).SetTranslate((-1, 2, 0))
    UsdGeom.XformCommonAPI(light).SetRotate((-70, 0, 10))
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
@pytest.mark.parametrize("mode", ["noMaterialResponse", "independent", "materialGlowTintsLight"])
def test_mesh_lights(
    host: HydraHost, tmp_path: Path, environment: dict[str, str], mode: str
) -> None:
    studio = Studio()
    for name in ("Above", "Box"):  # on either side of the lamp
        mesh = studio.box(f"/{name}")
        light = UsdLux.MeshLightAPI.Apply(mesh.GetPrim())
        lux = UsdLux.LightAPI(light.GetPrim())
        lux.CreateIntensityAttr(3)
        lux.GetMaterialSyncModeAttr().Set(mode)
        glow = studio.material(
            path=f"/Glow{name}", emissiveColor=Gf.Vec3f(1, 0.5, 0.2), diffuseColor=Gf.Vec3f(0.3)
        )
        UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(glow)
    UsdGeom.XformCommonAPI(studio.stage.GetPrimAtPath("/Above")).SetTranslate((-2, 1, 0))
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_a_shaped_light(host: HydraHost, tmp_path: Path, environment: dict[str, str]) -> None:
    studio = Studio()
    light = studio.light("SphereLight", "/Spot", radius=0.2, intensity=300.0)
    UsdGeom.XformCommonAPI(light).SetRotate((-90, 0, 0))
    shaping = UsdLux.ShapingAPI.Apply(light)
    shaping.CreateShapingConeAngleAttr(25)
    shaping.CreateShapingConeSoftnessAttr(0.3)
    shaping.CreateShapingFocusAttr(2)
    assert_parity(host, studio, tmp_path, environment)
