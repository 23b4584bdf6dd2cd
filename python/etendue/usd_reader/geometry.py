"""Gprims to GeometryDesc with the materials of their faces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from pxr import Usd, UsdGeom, UsdShade

from etendue.usd_reader.context import ReadContext, SkippingUnusable
from etendue.usd_reader.implicits import read_implicit
from etendue.usd_reader.materials import BoundMaterial, MaterialReader
from etendue.usd_reader.mesh import read_mesh


@dataclass(frozen=True)
class Surface:
    """A geometry of the scene and what its faces are made of."""

    geometry: int
    materials: tuple[BoundMaterial, ...]

    @property
    def material_indices(self) -> list[int]:
        """For ShapeDesc.materials."""
        return [material.index for material in self.materials]


class GeometryReader:
    """Fills SceneDescription.geometries, once per gprim."""

    def __init__(self, context: ReadContext, materials: MaterialReader) -> None:
        self._context = context
        self._materials = materials
        self._surfaces: dict[str, Surface | None] = {}

    def surface(self, prim: Usd.Prim) -> Surface | None:
        """The prim's surface; None (after a warning) when it has none that can be rendered."""
        path = str(prim.GetPath())
        if path not in self._surfaces:
            self._surfaces[path] = None
            with SkippingUnusable(self._context, prim):
                self._surfaces[path] = self._read(prim)
        return self._surfaces[path]

    def _read(self, prim: Usd.Prim) -> Surface | None:
        if prim.IsA(UsdGeom.Mesh):
            return self._read_mesh(prim)
        solid = read_implicit(self._context, prim)
        if solid is None:
            type_name = prim.GetTypeName()
            self._context.report.warn(
                f"gprim {type_name}", prim.GetPath(), f"{type_name} is not supported; skipped"
            )
            return None
        geometry = self._context.scene.add_geometry(solid)
        return Surface(geometry, (self._materials.bound(prim),))

    def _read_mesh(self, prim: Usd.Prim) -> Surface | None:
        if prim.HasAttribute("primvars:skel:jointIndices"):
            self._context.report.warn(
                "skinning", prim.GetPath(), "skinning is not supported; the rest pose is rendered"
            )
        materials = [self._materials.bound(prim)]
        face_materials = self._face_materials(prim, materials)
        st_name = self._st_name(prim, materials)
        mesh = read_mesh(self._context, prim, st_name, face_materials)
        if mesh is None:
            return None
        return Surface(self._context.scene.add_geometry(mesh), tuple(materials))

    def _face_materials(
        self, prim: Usd.Prim, materials: list[BoundMaterial]
    ) -> npt.NDArray[np.int32] | None:
        """Per face an index into `materials`, which is extended; None without subsets."""
        subsets = UsdShade.MaterialBindingAPI(prim).GetMaterialBindSubsets()
        if not subsets:
            return None
        counts = UsdGeom.Mesh(prim).GetFaceVertexCountsAttr().Get(self._context.time)
        faces = np.zeros(len(counts) if counts is not None else 0, dtype=np.int32)
        for subset in subsets:
            if subset.GetElementTypeAttr().Get(self._context.time) != UsdGeom.Tokens.face:
                self._context.report.warn(
                    "subset of something else than faces",
                    subset.GetPath(),
                    "only GeomSubsets of faces are supported; ignored",
                )
                continue
            value = subset.GetIndicesAttr().Get(self._context.time)
            indices = np.asarray([] if value is None else value, dtype=np.int64)
            valid = (indices >= 0) & (indices < len(faces))
            if not valid.all():
                self._context.report.warn(
                    f"subset indices {subset.GetPath()}",
                    subset.GetPath(),
                    "face indices out of range are ignored",
                )
            material = self._materials.bound(subset.GetPrim(), prim)
            if material not in materials:
                materials.append(material)
            faces[indices[valid]] = materials.index(material)
        return faces

    def _st_name(self, prim: Usd.Prim, materials: list[BoundMaterial]) -> str | None:
        """None when no material has a texture."""
        names = list(dict.fromkeys(material.st for material in materials if material.st))
        if not names:
            return None
        textured = [name for name in names if prim.HasAttribute(f"primvars:{name}")]
        if len(textured) > 1:
            self._context.report.warn(
                "several texture coordinates on a mesh",
                prim.GetPath(),
                f"its materials read several texture coordinates; '{textured[0]}' is used for all",
            )
        return textured[0] if textured else names[0]
