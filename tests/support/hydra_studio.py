"""Small stages rendered through Hydra and through the stage reader."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Unpack

import pytest
from pxr import Gf, Sdf, Usd, UsdGeom, UsdLux, UsdRender, UsdShade

import etendue
from etendue.settings import RenderOptions
from support.hydra_host import SCENE_INDEX, HydraHost
from support.path_order import open_in_path_order
from support.same_picture import Picture, assert_same_picture, read_color, rgb
from support.stage_builder import StageBuilder

SKY = Sdf.AssetPath(
    str(Path(__file__).resolve().parents[2] / "stages" / "textures" / "sundial.hdr")
)
SAMPLES = 4
PURPOSES = ("default", "render")
ENVIRONMENTS = pytest.mark.parametrize(
    "environment", [{}, SCENE_INDEX], ids=["delegates", "indices"]
)
_WIDTH = 64


class Studio(StageBuilder):
    """A floor of 8 x 8 under a lamp, seen from the front."""

    def __init__(self) -> None:
        super().__init__(Usd.Stage.CreateInMemory())
        UsdGeom.SetStageUpAxis(self.stage, "Y")
        floor = self.quad("/Floor")
        floor.GetPointsAttr().Set([(-4, 0, 4), (4, 0, 4), (4, 0, -4), (-4, 0, -4)])
        floor.CreateDisplayColorAttr([(0.6, 0.6, 0.6)])
        lamp = UsdLux.RectLight.Define(self.stage, "/Lamp")
        lamp.CreateIntensityAttr(20)
        UsdGeom.XformCommonAPI(lamp).SetTranslate((0, 5, 1))
        UsdGeom.XformCommonAPI(lamp).SetRotate((-90, 0, 0))
        camera = UsdGeom.Camera.Define(self.stage, "/Camera")
        camera.CreateHorizontalApertureAttr(36)
        camera.CreateVerticalApertureAttr(24)
        camera.CreateFocalLengthAttr(30)
        UsdGeom.XformCommonAPI(camera).SetTranslate((0, 2, 7))
        UsdGeom.XformCommonAPI(camera).SetRotate((-12, 0, 0))

    def box(self, path: str) -> UsdGeom.Mesh:
        """Half a box: two faces that meet at an edge."""
        mesh = UsdGeom.Mesh.Define(self.stage, path)
        mesh.CreateSubdivisionSchemeAttr("none")
        mesh.CreatePointsAttr([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, -1), (0, 1, -1)])
        mesh.CreateFaceVertexCountsAttr([4, 4])
        mesh.CreateFaceVertexIndicesAttr([0, 1, 2, 3, 4, 0, 3, 5])
        return mesh

    def colored(self, path: str, color: tuple[float, float, float]) -> UsdShade.Material:
        """Diffuse of that colour."""
        return self.material(path=path, diffuseColor=Gf.Vec3f(*color))

    def render_settings(self, **attributes: object) -> UsdRender.Settings:
        """The stage's own, so that they are the active ones."""
        settings = UsdRender.Settings.Define(self.stage, "/Settings")
        self.set(settings.GetPrim(), **attributes)
        self.stage.SetMetadata("renderSettingsPrimPath", "/Settings")
        return settings


def recorded(
    host: HydraHost,
    file: Path,
    environment: dict[str, str],
    purposes: Iterable[str] = PURPOSES,
) -> tuple[Picture, str]:
    """FrameRecorder's picture of a stage, and what the host said on stderr."""
    output = file.with_suffix(".exr")
    arguments = (file, "/Camera", _WIDTH, output, *purposes)
    told = {"HDETENDUE_SAMPLES_PER_PIXEL": str(SAMPLES), **environment}
    done = host.complete("record", *arguments, environment=told)
    return read_color(output), done.stderr


def reference(file: Path, ours: Picture, **options: Unpack[RenderOptions]) -> Picture:
    """The stage reader's picture, of the same size."""
    told: RenderOptions = {"spp": SAMPLES, "resolution": (ours.shape[1], ours.shape[0])}
    stage = etendue.open(open_in_path_order(file))
    return rgb(stage.render(camera="/Camera", **(told | options)))


def exported(studio: StageBuilder, folder: Path) -> Path:
    """The stage as a file."""
    file = folder / "stage.usda"
    studio.stage.GetRootLayer().Export(str(file))
    return file


def assert_parity(
    host: HydraHost,
    studio: StageBuilder,
    folder: Path,
    environment: dict[str, str],
    purposes: Iterable[str] = PURPOSES,
) -> str:
    """Both pictures of the stage are the same. Returns what the host said on stderr."""
    file = exported(studio, folder)
    ours, said = recorded(host, file, environment, purposes)
    assert_same_picture(ours, reference(file, ours))
    return said


def assert_parity_without(
    host: HydraHost, studio: StageBuilder, folder: Path, environment: dict[str, str], path: str
) -> str:
    """Through Hydra the stage looks as the reader's does when that prim is not active. Returns what
    the host said on stderr.
    """
    ours, said = recorded(host, exported(studio, folder), environment)
    studio.stage.GetPrimAtPath(path).SetActive(False)
    assert_same_picture(ours, reference(exported(studio, folder), ours))
    return said
