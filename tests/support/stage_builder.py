"""Small stages in memory, and what reading them gives."""

from __future__ import annotations

from typing import Any

from pxr import Sdf, Usd, UsdGeom, UsdShade

from etendue.usd_reader import StageContents, read_stage

Types = Sdf.ValueTypeNames


class StageBuilder:
    """A stage under construction, with the few things that most tests need."""

    def __init__(self, stage: Usd.Stage | None = None) -> None:
        self.stage = stage or Usd.Stage.CreateInMemory()

    def read(self, frame: float | None = None) -> StageContents:
        """What the reader makes of it."""
        return read_stage(self.stage, frame)

    def quad(self, path: str = "/Quad", **attributes: Any) -> UsdGeom.Mesh:
        """A polygon of four corners in the plane z = 0."""
        mesh = UsdGeom.Mesh.Define(self.stage, path)
        mesh.CreatePointsAttr([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])
        mesh.CreateFaceVertexCountsAttr([4])
        mesh.CreateFaceVertexIndicesAttr([0, 1, 2, 3])
        mesh.CreateSubdivisionSchemeAttr("none")
        self.set(mesh.GetPrim(), **attributes)
        return mesh

    def strip(self, path: str = "/Strip") -> UsdGeom.Mesh:
        """Three quads in a row: 8 points, 12 corners."""
        mesh = UsdGeom.Mesh.Define(self.stage, path)
        mesh.CreatePointsAttr([(x, y, 0) for y in (0, 1) for x in range(4)])
        mesh.CreateFaceVertexCountsAttr([4, 4, 4])
        mesh.CreateFaceVertexIndicesAttr([0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6])
        mesh.CreateSubdivisionSchemeAttr("none")
        return mesh

    def camera(self, path: str = "/Camera", **attributes: Any) -> UsdGeom.Camera:
        """A camera at (0.5, 0.5, 5)."""
        camera = UsdGeom.Camera.Define(self.stage, path)
        camera.AddTranslateOp().Set((0.5, 0.5, 5))
        self.set(camera.GetPrim(), **attributes)
        return camera

    def light(self, kind: str = "SphereLight", path: str = "/Light", **inputs: Any) -> Usd.Prim:
        """A light at (0.5, 0.5, 8): behind the camera, above the quad."""
        prim = self.stage.DefinePrim(path, kind)
        UsdGeom.Xformable(prim).AddTranslateOp().Set((0.5, 0.5, 8))
        for name, value in inputs.items():
            prim.GetAttribute(f"inputs:{name}").Set(value)
        return prim

    def lit_quad(self) -> StageBuilder:
        """Something that can be rendered."""
        self.quad()
        self.camera()
        self.light(intensity=50.0)
        return self

    def material(
        self,
        node: str = "UsdPreviewSurface",
        path: str = "/Material",
        context: str = "",
        **inputs: Any,
    ) -> UsdShade.Material:
        """A material of one surface node, whose path is <path>/Surface."""
        material = UsdShade.Material.Define(self.stage, path)
        shader = self.node(node, f"{path}/Surface", **inputs)
        output = (
            material.CreateSurfaceOutput(context) if context else material.CreateSurfaceOutput()
        )
        output.ConnectToSource(shader.CreateOutput("out", Types.Token))
        return material

    def node(self, node: str, path: str, **inputs: Any) -> UsdShade.Shader:
        """A shader node; inputs are values or UsdShade outputs."""
        shader = UsdShade.Shader.Define(self.stage, path)
        shader.CreateIdAttr(node)
        for name, value in inputs.items():
            if isinstance(value, UsdShade.Output | UsdShade.Input):
                shader.CreateInput(name, value.GetTypeName()).ConnectToSource(value)
            else:
                shader.CreateInput(name, _type_of(value)).Set(value)
        return shader

    def bind(self, prim: Any, material: UsdShade.Material) -> None:
        """Direct binding."""
        UsdShade.MaterialBindingAPI.Apply(prim.GetPrim()).Bind(material)

    @staticmethod
    def set(prim: Usd.Prim, **attributes: Any) -> None:
        """Sets attributes that the schema knows."""
        for name, value in attributes.items():
            prim.GetAttribute(name).Set(value)


def _type_of(value: Any) -> Sdf.ValueTypeName:
    if isinstance(value, bool):
        return Types.Bool
    if isinstance(value, int):
        return Types.Int
    if isinstance(value, float):
        return Types.Float
    if isinstance(value, str):
        return Types.Token
    if isinstance(value, Sdf.AssetPath):
        return Types.Asset
    return {2: Types.Float2, 3: Types.Color3f, 4: Types.Float4}[len(value)]


def warning_texts(contents: StageContents) -> str:
    """All warnings, one a line."""
    return "\n".join(str(warning) for warning in contents.warnings)
