"""Meshes, their subsets, and cameras, through Hydra and through the stage reader."""

from __future__ import annotations

from pathlib import Path

import pytest
from pxr import UsdGeom, UsdShade

import etendue
from support.hydra_host import SCENE_INDEX, HydraHost
from support.hydra_studio import ENVIRONMENTS, Studio, assert_parity, assert_parity_without


@ENVIRONMENTS
def test_subsets_and_their_materials(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    mesh = studio.box("/Box")
    binding = UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim())
    binding.Bind(studio.colored("/Red", (0.8, 0.1, 0.1)))
    subset = binding.CreateMaterialBindSubset("Side", [1])
    side = UsdShade.MaterialBindingAPI.Apply(subset.GetPrim())
    side.Bind(studio.colored("/Blue", (0.1, 0.1, 0.8)))
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_normals_and_a_left_handed_mesh_with_a_hole(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    strip = studio.strip()
    strip.CreateOrientationAttr("leftHanded")
    strip.CreateHoleIndicesAttr([1])
    strip.CreateNormalsAttr([(0, 0.3, 1)] * 6 + [(0.4, 0, 1)] * 6)
    strip.SetNormalsInterpolation("faceVarying")
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_a_subdivision_mesh_without_normals(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    studio.box("/Box").GetSubdivisionSchemeAttr().Set("catmullClark")
    with pytest.warns(etendue.EtendueWarning, match="catmullClark"):
        assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_an_orthographic_camera_with_offsets_and_exposure(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    studio = Studio()
    studio.box("/Box")
    camera = UsdGeom.Camera.Get(studio.stage, "/Camera")
    camera.CreateProjectionAttr("orthographic")
    camera.CreateHorizontalApertureAttr(60)
    camera.CreateVerticalApertureAttr(40)
    camera.CreateHorizontalApertureOffsetAttr(6)
    camera.CreateExposureAttr(-1)
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
def test_a_lens(host: HydraHost, tmp_path: Path, environment: dict[str, str]) -> None:
    studio = Studio()
    studio.box("/Box")
    camera = UsdGeom.Camera.Get(studio.stage, "/Camera")
    camera.CreateFStopAttr(0.5)
    camera.CreateFocusDistanceAttr(5)
    camera.CreateExposureIsoAttr(200)
    assert_parity(host, studio, tmp_path, environment)


@ENVIRONMENTS
@pytest.mark.parametrize("scale", [(0, 1, 1), (0, 0, 0)])
def test_what_has_no_extent_is_left_out(
    host: HydraHost,
    tmp_path: Path,
    environment: dict[str, str],
    scale: tuple[float, float, float],
) -> None:
    studio = Studio()
    studio.box("/Box")
    UsdGeom.XformCommonAPI(studio.box("/Flat")).SetScale(scale)
    said = assert_parity_without(host, studio, tmp_path, environment, "/Flat")
    assert "</Flat>: its transform is singular" in said


def test_a_ball_without_radius_is_left_out(host: HydraHost, tmp_path: Path) -> None:
    studio = Studio()
    studio.box("/Box")
    UsdGeom.Sphere.Define(studio.stage, "/Ball").CreateRadiusAttr(0)
    said = assert_parity_without(host, studio, tmp_path, SCENE_INDEX, "/Ball")
    assert "</Ball>: it is left out" in said
