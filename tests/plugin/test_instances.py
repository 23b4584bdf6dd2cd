"""Instances, and what is not shown, through Hydra and through the stage reader."""

from __future__ import annotations

from pathlib import Path

import pytest
from pxr import Gf, UsdGeom, UsdLux

from support.hydra_host import HydraHost
from support.hydra_studio import ENVIRONMENTS, Studio, assert_parity


@ENVIRONMENTS
def test_nested_point_instancers(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    inner = UsdGeom.PointInstancer.Define(studio.stage, "/Outer/Inner")
    studio.box("/Outer/Inner/Box")
    UsdGeom.XformCommonAPI(studio.stage.GetPrimAtPath("/Outer/Inner/Box")).SetTranslate((0, 0, 1))
    inner.CreatePrototypesRel().SetTargets(["/Outer/Inner/Box"])
    inner.CreateProtoIndicesAttr([0, 0])
    inner.CreatePositionsAttr([(-1, 0, 0), (1, 0, 0)])
    inner.CreateScalesAttr([(0.5, 0.5, 0.5), (0.5, 1, 0.5)])
    turn = Gf.Rotation((0, 1, 0), 40).GetQuat()
    inner.CreateOrientationsAttr([Gf.Quath(1), Gf.Quath(turn)])
    outer = UsdGeom.PointInstancer.Define(studio.stage, "/Outer")
    outer.CreatePrototypesRel().SetTargets(["/Outer/Inner"])
    outer.CreateProtoIndicesAttr([0, 0, 0])
    outer.CreatePositionsAttr([(-2, 0, 0), (1, 0, -1), (0, 1, 1)])
    outer.CreateInvisibleIdsAttr([2])
    UsdGeom.XformCommonAPI(outer).SetRotate((0, 20, 0))
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_native_instances(host: HydraHost, tmp_path: Path, environment: dict[str, str]) -> None:
    studio = Studio()
    studio.stage.CreateClassPrim("/Class")
    studio.box("/Class/Box").CreateDisplayColorAttr([(0.2, 0.4, 0.8)])
    for index in range(3):
        place = UsdGeom.Xform.Define(studio.stage, f"/Copy{index}")
        place.GetPrim().GetReferences().AddInternalReference("/Class")
        place.GetPrim().SetInstanceable(True)
        UsdGeom.XformCommonAPI(place).SetTranslate((2 * index - 2.5, 0, -index))
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_instanced_lights(host: HydraHost, tmp_path: Path, environment: dict[str, str]) -> None:
    studio = Studio()
    instancer = UsdGeom.PointInstancer.Define(studio.stage, "/Lamps")
    lamp = UsdLux.SphereLight.Define(studio.stage, "/Lamps/Lamp/Light")
    lamp.CreateRadiusAttr(0.2)
    lamp.CreateIntensityAttr(30)
    UsdGeom.XformCommonAPI(lamp).SetTranslate((0, 1, 0))
    instancer.CreatePrototypesRel().SetTargets(["/Lamps/Lamp"])
    instancer.CreateProtoIndicesAttr([0, 0])
    instancer.CreatePositionsAttr([(-2, 0, 0), (2, 0, -1)])
    assert_parity(host, studio, tmp_path, environment)


NESTED = ("/Outer", "/Outer/Inner", "/Outer/Inner/Box", "/Outer/Own")
PROTOTYPES = NESTED[1:]


def nested(studio: Studio) -> None:
    """An instancer of a box of its own and of another instancer of boxes."""
    inner = UsdGeom.PointInstancer.Define(studio.stage, "/Outer/Inner")
    studio.box("/Outer/Inner/Box")
    inner.CreatePrototypesRel().SetTargets(["/Outer/Inner/Box"])
    inner.CreateProtoIndicesAttr([0, 0])
    inner.CreatePositionsAttr([(-1, 0, 0), (1, 0, 0)])
    outer = UsdGeom.PointInstancer.Define(studio.stage, "/Outer")
    studio.box("/Outer/Own").CreateDisplayColorAttr([(0.2, 0.4, 0.8)])
    outer.CreatePrototypesRel().SetTargets(["/Outer/Inner", "/Outer/Own"])
    outer.CreateProtoIndicesAttr([0, 0, 1])
    outer.CreatePositionsAttr([(-2, 0, 0), (1, 0, -1), (0, 1, 1)])


@ENVIRONMENTS
@pytest.mark.parametrize("path", NESTED)
def test_invisible_parts_of_instancers(
    host: HydraHost, tmp_path: Path, environment: dict[str, str], path: str
) -> None:
    if environment and path in PROTOTYPES:
        pytest.skip("scene indices of OpenUSD 25.08 call every prototype visible")
    studio = Studio()
    nested(studio)
    UsdGeom.Imageable.Get(studio.stage, path).CreateVisibilityAttr("invisible")
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
@pytest.mark.parametrize("path", NESTED)
def test_guides_in_instancers(
    host: HydraHost, tmp_path: Path, environment: dict[str, str], path: str
) -> None:
    studio = Studio()
    nested(studio)
    UsdGeom.Imageable.Get(studio.stage, path).CreatePurposeAttr("guide")
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_invisible_prims(host: HydraHost, tmp_path: Path, environment: dict[str, str]) -> None:
    studio = Studio()
    group = UsdGeom.Xform.Define(studio.stage, "/Group")
    group.CreateVisibilityAttr("invisible")
    studio.box("/Group/Box")
    UsdLux.SphereLight.Define(studio.stage, "/Group/Lamp").CreateIntensityAttr(50)
    studio.box("/Box").CreateVisibilityAttr("invisible")
    UsdLux.DomeLight.Define(studio.stage, "/Sky").CreateVisibilityAttr("invisible")
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
@pytest.mark.parametrize(
    "purposes",
    [("default", "render"), ("default", "proxy"), ("default", "render", "proxy", "guide")],
    ids=",".join,
)
def test_purposes(
    host: HydraHost, tmp_path: Path, environment: dict[str, str], purposes: tuple[str, ...]
) -> None:
    studio = Studio()
    for index, purpose in enumerate(("default", "render", "proxy", "guide")):
        group = UsdGeom.Xform.Define(studio.stage, f"/Group{index}")
        group.CreatePurposeAttr(purpose)
        UsdGeom.XformCommonAPI(group).SetTranslate((1.5 * index - 3, 0, 0))
        studio.box(f"/Group{index}/Box")
    # Below a purpose, another one.
    studio.box("/Group3/Other").CreatePurposeAttr("render")
    UsdGeom.XformCommonAPI(studio.stage.GetPrimAtPath("/Group3/Other")).SetTranslate((0, 1, 0))
    studio.render_settings(includedPurposes=purposes)
    assert_parity(host, studio, tmp_path, environment, purposes)
