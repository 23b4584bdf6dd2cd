"""The stage that storms of edits go over, and that behaviour is tried on."""

from __future__ import annotations

import random
from pathlib import Path

import numpy as np
from pxr import Gf, Sdf, Usd, UsdGeom, UsdLux, UsdShade

from support.hdr_file import write_hdr

Types = Sdf.ValueTypeNames

SHEETS = 6
MATERIALS = 3
#: Edited like any other prim, and with it all that is in it.
GROUP = "/World/Group"
COPIES = "/World/Copies"
INNER_COPIES = f"{COPIES}/Inner"
LAMP = "/Lamp"
SECOND_LAMP = "/SecondLamp"
CAMERA = "/Camera"


def grid(mesh: UsdGeom.Mesh, cells: int, height: float) -> None:
    """A sheet of cells x cells quads over [-1, 1]^2 with a bump in the middle."""
    ticks = [2 * i / cells - 1 for i in range(cells + 1)]
    places = [(x, y) for y in ticks for x in ticks]
    row = cells + 1
    corners = []
    for y in range(cells):
        for x in range(cells):
            at = y * row + x
            corners += [at, at + row, at + row + 1, at + 1]
    points = [(x, height * (1 - x * x) * (1 - y * y), y) for x, y in places]
    mesh.GetPointsAttr().Set(points)
    mesh.GetFaceVertexCountsAttr().Set([4] * (cells * cells))
    mesh.GetFaceVertexIndicesAttr().Set(corners)
    coordinates = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar("st", Types.TexCoord2fArray, "vertex")
    coordinates.Set([Gf.Vec2f((x + 1) / 2, (y + 1) / 2) for x, y in places])


class StormScene:
    """A floor under a sky, sheets with subsets, nested instancers, a lamp and a camera."""

    def __init__(self, chance: random.Random, folder: Path) -> None:
        """Textures are written to `folder`."""
        self.chance = chance
        self.stage = Usd.Stage.CreateInMemory()
        UsdGeom.SetStageUpAxis(self.stage, "Y")
        self.textures = [self._texture(folder, index) for index in range(2)]
        self.materials = [self._material(index) for index in range(MATERIALS)]
        UsdGeom.Xform.Define(self.stage, GROUP)
        for index in range(SHEETS):
            self.sheet(index)
        floor = self._mesh("/World/Floor", 1, 0.0)
        UsdGeom.XformCommonAPI(floor).SetScale((4, 1, 4))
        self._camera()
        self._lights()
        self._instancers()

    # ---------------------------------------------------------------------------- what is edited

    def sheet(self, index: int) -> UsdGeom.Mesh:
        """That sheet, made anew if it was taken away; every second one is in the group."""
        path = f"{GROUP if index % 2 else '/World'}/Sheet{index}"
        if not self.stage.GetPrimAtPath(path):
            mesh = self._mesh(path, self.chance.randint(1, 6), 0.5)
            binding = UsdShade.MaterialBindingAPI(mesh.GetPrim())
            self.bind(binding.CreateMaterialBindSubset("Part", [0]))
            self.place(mesh)
        return UsdGeom.Mesh.Get(self.stage, path)

    def any_sheet(self) -> UsdGeom.Mesh:
        """One of them."""
        return self.sheet(self.chance.randrange(SHEETS))

    def any_imageable(self) -> UsdGeom.Imageable:
        """Something to be hidden, re-tagged or moved."""
        paths = (GROUP, COPIES, INNER_COPIES, f"{COPIES}/Prototype", f"{INNER_COPIES}/Prototype")
        sheets = [self.any_sheet().GetPath() for _ in range(2 * len(paths))]
        return UsdGeom.Imageable.Get(self.stage, self.chance.choice((*paths, *sheets)))

    def surface(self) -> UsdShade.Shader:
        """The surface shader of one of the materials."""
        path = self.chance.choice(self.materials).GetPath()
        return UsdShade.Shader.Get(self.stage, path.AppendChild("Surface"))

    def place(self, prim: UsdGeom.Imageable) -> None:
        """Somewhere over the floor."""
        chance = self.chance.uniform
        place = UsdGeom.XformCommonAPI(prim)
        place.SetTranslate((chance(-3, 3), chance(0, 3), chance(-3, 3)))
        place.SetRotate((chance(-60, 60), chance(-60, 60), 0))

    def bind(self, bound: UsdGeom.Mesh | UsdGeom.Subset) -> None:
        """To one of the materials."""
        binding = UsdShade.MaterialBindingAPI.Apply(bound.GetPrim())
        binding.Bind(self.chance.choice(self.materials))

    def scatter(self, instancer: UsdGeom.PointInstancer) -> None:
        """Up to five copies of its prototypes."""
        chance = self.chance.uniform
        count = self.chance.randint(1, 5)
        kinds = len(instancer.GetPrototypesRel().GetTargets())
        indices = [self.chance.randrange(kinds) for _ in range(count)]
        instancer.CreateProtoIndicesAttr().Set(indices)
        places = [Gf.Vec3f(chance(-3, 3), chance(0, 2), chance(-3, 3)) for _ in range(count)]
        instancer.CreatePositionsAttr().Set(places)
        instancer.CreateScalesAttr().Set([Gf.Vec3f(chance(0.1, 0.5))] * count)

    # --------------------------------------------------------------------------------- building

    def _texture(self, folder: Path, index: int) -> Sdf.AssetPath:
        file = folder / f"texture{index}.hdr"
        write_hdr(file, np.random.default_rng(index).uniform(0.1, 0.9, (4 + index, 4, 3)))
        return Sdf.AssetPath(str(file))

    def _material(self, index: int) -> UsdShade.Material:
        material = UsdShade.Material.Define(self.stage, f"/World/Material{index}")
        shader = UsdShade.Shader.Define(self.stage, f"/World/Material{index}/Surface")
        shader.CreateIdAttr("UsdPreviewSurface")
        shader.CreateInput("diffuseColor", Types.Color3f).Set((0.5, 0.5, 0.5))
        output = shader.CreateOutput("surface", Types.Token)
        material.CreateSurfaceOutput().ConnectToSource(output)
        image = UsdShade.Shader.Define(self.stage, f"/World/Material{index}/Image")
        image.CreateIdAttr("UsdUVTexture")
        image.CreateInput("file", Types.Asset).Set(self.textures[0])
        image.CreateOutput("rgb", Types.Float3)
        return material

    def _mesh(self, path: str, cells: int, height: float) -> UsdGeom.Mesh:
        mesh = UsdGeom.Mesh.Define(self.stage, path)
        mesh.CreateSubdivisionSchemeAttr("none")
        grid(mesh, cells, height)
        self.bind(mesh)
        return mesh

    def _camera(self) -> None:
        camera = UsdGeom.Camera.Define(self.stage, CAMERA)
        camera.GetHorizontalApertureAttr().Set(36.0)
        camera.GetVerticalApertureAttr().Set(24.0)
        camera.GetFocalLengthAttr().Set(35.0)
        UsdGeom.XformCommonAPI(camera).SetTranslate((0, 2, 9))

    def _lights(self) -> None:
        lamp = UsdLux.RectLight.Define(self.stage, LAMP)
        lamp.GetIntensityAttr().Set(30.0)
        UsdGeom.XformCommonAPI(lamp).SetTranslate((0, 6, 0))
        UsdGeom.XformCommonAPI(lamp).SetRotate((-90, 0, 0))
        # Never edited: no edit may leave nothing to be seen.
        UsdLux.DomeLight.Define(self.stage, "/Sky").GetIntensityAttr().Set(0.1)

    def _instancers(self) -> None:
        for path in (INNER_COPIES, COPIES):
            instancer = UsdGeom.PointInstancer.Define(self.stage, path)
            prototypes = [self._mesh(f"{path}/Prototype", 2, 1.0).GetPath()]
            if path == COPIES:
                prototypes.append(Sdf.Path(INNER_COPIES))
            instancer.CreatePrototypesRel().SetTargets(prototypes)
            self.scatter(instancer)
