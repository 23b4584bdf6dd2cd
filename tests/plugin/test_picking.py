"""Which prim, instance and face a pixel shows."""

from __future__ import annotations

from pathlib import Path

from pxr import Gf, Usd, UsdGeom, UsdLux

from support.hydra_host import SCENE_INDEX, HydraHost, skip_without_library

SIZE = (40, 40)


def board(stage: Usd.Stage, path: str, left: float) -> UsdGeom.Mesh:
    """Three squares in a row, from `left` on; the first one is a hole."""
    mesh = UsdGeom.Mesh.Define(stage, path)
    mesh.CreateSubdivisionSchemeAttr("none")
    mesh.CreatePointsAttr([(left + i // 2, i % 2, 0) for i in range(8)])
    mesh.CreateFaceVertexCountsAttr([4, 4, 4])
    corners = [corner for i in (0, 2, 4) for corner in (i, i + 2, i + 3, i + 1)]
    mesh.CreateFaceVertexIndicesAttr(corners)
    mesh.CreateHoleIndicesAttr([0])
    return mesh


def build(path: Path) -> None:
    """A board, a ball above it, three more boards below, a lamp; ten units wide and high."""
    stage = Usd.Stage.CreateNew(str(path))
    UsdGeom.SetStageUpAxis(stage, "Y")
    board(stage, "/Board", -4.0)
    ball = UsdGeom.Sphere.Define(stage, "/Ball")
    UsdGeom.XformCommonAPI(ball).SetTranslate((0, 3, 0))
    copies = UsdGeom.PointInstancer.Define(stage, "/Copies")
    board(stage, "/Copies/Prototype", 0.0)
    copies.CreatePrototypesRel().SetTargets(["/Copies/Prototype"])
    copies.CreateProtoIndicesAttr([0, 0, 0])
    copies.CreatePositionsAttr([Gf.Vec3f(x, -2, 0) for x in (2, -1, -4)])
    lamp = UsdLux.SphereLight.Define(stage, "/Lamp")
    lamp.CreateRadiusAttr(0.5)
    UsdGeom.XformCommonAPI(lamp).SetTranslate((3, 3, 0))
    camera = UsdGeom.Camera.Define(stage, "/Camera")
    camera.CreateProjectionAttr("orthographic")
    camera.CreateHorizontalApertureAttr(100)
    camera.CreateVerticalApertureAttr(100)
    UsdGeom.XformCommonAPI(camera).SetTranslate((0, 0, 10))
    stage.Save()


def pixel(x: float, y: float) -> tuple[int, int]:
    """That shows this point of the plane z = 0."""
    return int((x + 5) * SIZE[0] / 10), int((5 - y) * SIZE[1] / 10)


SHOWN = {
    (0.0, 3.0): "/Ball 0 0",
    (-3.5, 0.5): "nothing -1 -1",  # through the hole
    (-2.5, 0.5): "/Board 0 1",
    (-1.5, 0.5): "/Board 0 2",
    (3.5, -1.5): "/Copies/Prototype 0 1",
    (4.5, -1.5): "/Copies/Prototype 0 2",
    (0.5, -1.5): "/Copies/Prototype 1 1",
    (-1.5, -1.5): "/Copies/Prototype 2 2",
    (0.0, -4.0): "nothing -1 -1",
    (3.0, 3.0): "nothing -1 -1",  # Hydra has no identifiers for lights
}


def test_pixels_know_what_they_show(host: HydraHost, tmp_path: Path) -> None:
    skip_without_library()
    stage = tmp_path / "stage.usda"
    build(stage)
    pixels = [number for point in SHOWN for number in pixel(*point)]
    environment = {**SCENE_INDEX, "HDETENDUE_SAMPLES_PER_PIXEL": "1"}
    said = host.run("picking", stage, "/Camera", *SIZE, *pixels, environment=environment)
    assert dict(zip(SHOWN, said.splitlines(), strict=True)) == SHOWN
