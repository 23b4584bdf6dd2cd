"""Edits a stage at random while it is rendered, then renders its final state twice: through the
engine that went through all the edits, and through a fresh one.

edit_storm.py EDITS SEED AFTER FRESH

Prints "memory" and the resident memory, in KiB, after a fifth of the edits and after all.
"""

from __future__ import annotations

import random
import sys
import time
from collections.abc import Callable
from pathlib import Path

from pxr import Gf, Sdf, Usd, UsdGeom, UsdLux, UsdShade

from plugin.host.live_engine import LiveEngine

SIZE = (48, 32)
SHAPES = 6
SAMPLES_WHILE_EDITING = 100_000
SAMPLES_AT_THE_END = 4


def grid(mesh: UsdGeom.Mesh, cells: int, height: float) -> None:
    """A sheet of cells x cells quads over [-1, 1]^2 with a bump in the middle."""
    ticks = [2 * i / cells - 1 for i in range(cells + 1)]
    points = [(x, height * (1 - x * x) * (1 - y * y), y) for y in ticks for x in ticks]
    row = cells + 1
    corners = []
    for y in range(cells):
        for x in range(cells):
            at = y * row + x
            corners += [at, at + row, at + row + 1, at + 1]
    mesh.GetPointsAttr().Set(points)
    mesh.GetFaceVertexCountsAttr().Set([4] * (cells * cells))
    mesh.GetFaceVertexIndicesAttr().Set(corners)


class Scene:
    """A floor, some sheets, an instancer, a lamp and a camera, and the edits that they bear."""

    def __init__(self, chance: random.Random) -> None:
        self._chance = chance
        self.stage = Usd.Stage.CreateInMemory()
        UsdGeom.SetStageUpAxis(self.stage, "Y")
        self._materials = [self._material(index) for index in range(3)]
        for index in range(SHAPES):
            self._sheet(index)
        floor = self._mesh("/World/Floor", 1, 0.0)
        UsdGeom.XformCommonAPI(floor).SetScale((4, 1, 4))
        self._camera()
        self._lamp()
        self._instancer()

    def edit(self) -> None:
        """One random edit."""
        edits: tuple[Callable[[], None], ...] = (
            self._move,
            self._recolor,
            self._dim,
            self._turn_camera,
            self._remesh,
            self._hide,
            self._rebind,
            self._take_away,
            self._scatter,
        )
        self._chance.choice(edits)()

    # --------------------------------------------------------------------------------- building

    def _material(self, index: int) -> UsdShade.Material:
        material = UsdShade.Material.Define(self.stage, f"/World/Material{index}")
        shader = UsdShade.Shader.Define(self.stage, f"/World/Material{index}/Surface")
        shader.CreateIdAttr("UsdPreviewSurface")
        shader.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f).Set((0.5, 0.5, 0.5))
        output = shader.CreateOutput("surface", Sdf.ValueTypeNames.Token)
        material.CreateSurfaceOutput().ConnectToSource(output)
        return material

    def _mesh(self, path: str, cells: int, height: float) -> UsdGeom.Mesh:
        mesh = UsdGeom.Mesh.Define(self.stage, path)
        mesh.CreateSubdivisionSchemeAttr("none")
        grid(mesh, cells, height)
        self._bind(mesh)
        return mesh

    def _sheet(self, index: int) -> None:
        mesh = self._mesh(f"/World/Sheet{index}", self._chance.randint(1, 6), 0.5)
        self._place(mesh)

    def _camera(self) -> None:
        camera = UsdGeom.Camera.Define(self.stage, "/Camera")
        camera.GetHorizontalApertureAttr().Set(36.0)
        camera.GetVerticalApertureAttr().Set(24.0)
        camera.GetFocalLengthAttr().Set(35.0)
        UsdGeom.XformCommonAPI(camera).SetTranslate((0, 2, 9))

    def _lamp(self) -> None:
        lamp = UsdLux.RectLight.Define(self.stage, "/Lamp")
        lamp.GetIntensityAttr().Set(30.0)
        UsdGeom.XformCommonAPI(lamp).SetTranslate((0, 6, 0))
        UsdGeom.XformCommonAPI(lamp).SetRotate((-90, 0, 0))

    def _instancer(self) -> None:
        instancer = UsdGeom.PointInstancer.Define(self.stage, "/World/Copies")
        self._mesh("/World/Copies/Prototype", 2, 1.0)
        instancer.CreatePrototypesRel().SetTargets(["/World/Copies/Prototype"])
        self._scatter()

    # ---------------------------------------------------------------------------------- editing

    def _any_sheet(self) -> UsdGeom.Mesh:
        index = self._chance.randrange(SHAPES)
        path = f"/World/Sheet{index}"
        if not self.stage.GetPrimAtPath(path):
            self._sheet(index)
        return UsdGeom.Mesh.Get(self.stage, path)

    def _place(self, mesh: UsdGeom.Mesh) -> None:
        chance = self._chance.uniform
        place = UsdGeom.XformCommonAPI(mesh)
        place.SetTranslate((chance(-3, 3), chance(0, 3), chance(-3, 3)))
        place.SetRotate((chance(-60, 60), chance(-60, 60), 0))

    def _bind(self, mesh: UsdGeom.Mesh) -> None:
        UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(self._chance.choice(self._materials))

    def _move(self) -> None:
        self._place(self._any_sheet())

    def _recolor(self) -> None:
        path = self._chance.choice(self._materials).GetPath().AppendChild("Surface")
        color = Gf.Vec3f(*(self._chance.uniform(0.1, 0.9) for _ in range(3)))
        UsdShade.Shader.Get(self.stage, path).GetInput("diffuseColor").Set(color)

    def _dim(self) -> None:
        lamp = UsdLux.RectLight.Get(self.stage, "/Lamp")
        lamp.GetIntensityAttr().Set(self._chance.uniform(10, 60))
        lamp.GetWidthAttr().Set(self._chance.uniform(0.5, 3))

    def _turn_camera(self) -> None:
        camera = UsdGeom.Camera.Get(self.stage, "/Camera")
        UsdGeom.XformCommonAPI(camera).SetRotate((-10, self._chance.uniform(-15, 15), 0))

    def _remesh(self) -> None:
        grid(self._any_sheet(), self._chance.randint(1, 8), self._chance.uniform(0, 1))

    def _hide(self) -> None:
        attribute = self._any_sheet().GetVisibilityAttr()
        attribute.Set(self._chance.choice(("inherited", "invisible")))

    def _rebind(self) -> None:
        self._bind(self._any_sheet())

    def _take_away(self) -> None:
        self.stage.RemovePrim(self._any_sheet().GetPath())

    def _scatter(self) -> None:
        chance = self._chance.uniform
        count = self._chance.randint(1, 5)
        instancer = UsdGeom.PointInstancer.Get(self.stage, "/World/Copies")
        instancer.CreateProtoIndicesAttr().Set([0] * count)
        places = [Gf.Vec3f(chance(-3, 3), chance(0, 2), chance(-3, 3)) for _ in range(count)]
        instancer.CreatePositionsAttr().Set(places)
        instancer.CreateScalesAttr().Set([Gf.Vec3f(chance(0.1, 0.5))] * count)


def resident_memory() -> int:
    """KiB."""
    for line in Path("/proc/self/status").read_text(encoding="ascii").splitlines():
        if line.startswith("VmRSS"):
            return int(line.split()[1])
    raise RuntimeError("no VmRSS")


def storm(edits: int, seed: int, after: Path, fresh: Path) -> None:
    """See the module."""
    chance = random.Random(seed)
    scene = Scene(chance)
    engine = LiveEngine(scene.stage, "/Camera", SIZE)
    engine.set(samplesPerPixel=SAMPLES_WHILE_EDITING)
    memory = []
    for number in range(1, edits + 1):
        scene.edit()
        if engine.step():
            raise RuntimeError(f"nothing was being rendered after edit {number}")
        if chance.random() < 0.1:
            time.sleep(chance.uniform(0, 0.05))
            engine.step()
        if number in (max(edits // 5, 1), edits):
            memory.append(resident_memory())
    print("memory", *memory)
    for live, output in ((engine, after), (LiveEngine(scene.stage, "/Camera", SIZE), fresh)):
        live.set(samplesPerPixel=SAMPLES_AT_THE_END)
        live.picture(output)


if __name__ == "__main__":
    storm(int(sys.argv[1]), int(sys.argv[2]), Path(sys.argv[3]), Path(sys.argv[4]))
