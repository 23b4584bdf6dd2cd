"""The walk over the stage: shapes, lights and instances, to two levels (group, instance)."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt
from pxr import Usd, UsdGeom

from etendue import _core
from etendue.usd_reader import instances
from etendue.usd_reader.context import Matrix, ReadContext, SkippingUnusable, column_matrix
from etendue.usd_reader.geometry import GeometryReader, Surface
from etendue.usd_reader.lights import (
    NO_RESPONSE,
    TINTED,
    is_light,
    material_sync_mode,
    read_light,
)
from etendue.usd_reader.materials import MaterialReader

Matrices = npt.NDArray[np.float64]  # (n, 4, 4)

_PREDICATE = Usd.TraverseInstanceProxies(Usd.PrimDefaultPredicate)
# Prototypes of point instancers often stand under an "over" or a "class" that keeps them out of
# the picture.
_PROTOTYPE_PREDICATE = Usd.TraverseInstanceProxies(Usd.PrimIsActive & Usd.PrimIsLoaded)


@dataclass
class Placement:
    """Copies of a group; matrices lead from the group to the content that holds the placement."""

    group: int
    name: str
    matrices: Matrices


@dataclass
class Content:
    """What a subtree holds, in the space of its root; nested instances are flattened."""

    shapes: list[_core.ShapeDesc] = field(default_factory=list)
    lights: list[tuple[Usd.Prim, Matrix]] = field(default_factory=list)
    placements: list[Placement] = field(default_factory=list)


@dataclass(frozen=True)
class _Place:
    """Where the walk stands."""

    root_from_prim: Matrix
    purpose: UsdGeom.Imageable.PurposeInfo
    predicate: Usd.PrimFlagsPredicate


class StageWalk:
    """Fills the shapes, groups, instances and lights of the context's scene."""

    def __init__(self, context: ReadContext) -> None:
        self._context = context
        self._materials = MaterialReader(context)
        self._geometry = GeometryReader(context, self._materials)
        self._keys = instances.NativeKeys()
        self._natives: dict[instances.NativeKey, Content] = {}
        self._prototypes: dict[str, Content] = {}
        self._xforms = UsdGeom.XformCache(context.time)

    def run(self) -> None:
        """Reads the whole stage."""
        content = Content()
        root = self._context.stage.GetPseudoRoot()
        place = _Place(np.eye(4), UsdGeom.Imageable.PurposeInfo(), _PREDICATE)
        for child in root.GetFilteredChildren(_PREDICATE):
            self._visit(child, place, content)
        scene = self._context.scene
        for shape in content.shapes:
            scene.add_shape(shape)
        for prim, matrix in content.lights:
            self._add_light(prim, matrix)
        for placement in content.placements:
            scene.add_instances(placement.name, placement.group, placement.matrices)

    # --------------------------------------------------------------------------------- walking

    def _visit(self, prim: Usd.Prim, place: _Place, content: Content) -> None:
        """A prim and what is below it."""
        purpose = place.purpose
        if prim.IsA(UsdGeom.Imageable):
            imageable = UsdGeom.Imageable(prim)
            if imageable.GetVisibilityAttr().Get(self._context.time) == UsdGeom.Tokens.invisible:
                return
            purpose = imageable.ComputePurposeInfo(purpose)
        local, resets = self._xforms.GetLocalTransformation(prim)
        matrix = column_matrix(local)
        if not resets:
            matrix = place.root_from_prim @ matrix
        self._visit_at(prim, _Place(matrix, purpose, place.predicate), content)

    def _visit_at(self, prim: Usd.Prim, place: _Place, content: Content) -> None:
        """A prim whose transform, visibility and purpose are settled."""
        if prim.IsInstance():
            native = self._native(prim, place)
            _include(content, native, str(prim.GetPath()), place.root_from_prim[np.newaxis])
        elif prim.IsA(UsdGeom.PointInstancer):
            if self._is_included(place):
                self._include_point_instances(prim, place, content)
        else:
            self._visit_plain(prim, place, content)

    def _visit_plain(self, prim: Usd.Prim, place: _Place, content: Content) -> None:
        if self._is_included(place):
            if is_light(prim):
                content.lights.append((prim, place.root_from_prim))
            elif prim.IsA(UsdGeom.Gprim):
                surface = self._geometry.surface(prim)
                if surface is not None:
                    content.shapes.append(_shape(prim, surface, place.root_from_prim))
        for child in prim.GetFilteredChildren(place.predicate):
            self._visit(child, place, content)

    def _is_included(self, place: _Place) -> bool:
        return str(place.purpose.purpose or "default") in self._context.purposes

    # ------------------------------------------------------------------------------- instances

    def _native(self, prim: Usd.Prim, place: _Place) -> Content:
        """The content of a native instance, read through the first instance of its kind."""
        purpose = str(place.purpose.GetInheritablePurpose())
        key = self._keys.key(prim, purpose)
        if key not in self._natives:
            content = Content()
            self._visit_plain(prim, _Place(np.eye(4), place.purpose, place.predicate), content)
            self._natives[key] = self._grouped(content, str(prim.GetPath()))
        return self._natives[key]

    def _prototype(self, prim: Usd.Prim) -> Content:
        """The content of a point instancer's prototype, in the space of its root prim."""
        path = str(prim.GetPath())
        if path not in self._prototypes:
            content = Content()
            imageable = UsdGeom.Imageable(prim)
            visibility = imageable.GetVisibilityAttr().Get(self._context.time) if imageable else ""
            if visibility != UsdGeom.Tokens.invisible:
                purpose = (
                    imageable.ComputePurposeInfo() if imageable else UsdGeom.Imageable.PurposeInfo()
                )
                self._visit_at(prim, _Place(np.eye(4), purpose, _PROTOTYPE_PREDICATE), content)
            self._prototypes[path] = self._grouped(content, path)
        return self._prototypes[path]

    def _grouped(self, content: Content, name: str) -> Content:
        """The same content with its shapes turned into a group placed once."""
        if content.shapes:
            group = self._context.scene.add_group(_core.GroupDesc(name=name, shapes=content.shapes))
            content.placements.append(Placement(group, name, np.eye(4)[np.newaxis]))
            content.shapes = []
        return content

    def _include_point_instances(self, prim: Usd.Prim, place: _Place, content: Content) -> None:
        with SkippingUnusable(self._context, prim):
            for prototype, matrices in instances.point_instances(self._context, prim):
                _include(
                    content,
                    self._prototype(prototype),
                    str(prim.GetPath()),
                    place.root_from_prim @ matrices,
                )

    # ---------------------------------------------------------------------------------- lights

    def _add_light(self, prim: Usd.Prim, matrix: Matrix) -> None:
        light = None
        with SkippingUnusable(self._context, prim):
            light = read_light(self._context, prim)
        if light is None:
            return
        if light.kind == _core.LightKind.Mesh:
            surface = self._geometry.surface(prim)
            if surface is None:
                return
            shape = _shape(prim, surface, matrix)
            mode = material_sync_mode(self._context, prim)
            if mode == NO_RESPONSE:
                shape.materials = [self._materials.black().index] * len(surface.materials)
            elif mode == TINTED and not any(material.emits for material in surface.materials):
                self._context.report.warn(
                    "mesh light without glow",
                    prim.GetPath(),
                    f"{TINTED} multiplies the light by its material's emission, which is black: "
                    "it emits nothing",
                )
            light.shape = self._context.scene.add_shape(shape)
        light.world_from_light = matrix
        self._context.scene.add_light(light)


def _shape(prim: Usd.Prim, surface: Surface, matrix: Matrix) -> _core.ShapeDesc:
    return _core.ShapeDesc(
        name=str(prim.GetPath()),
        geometry=surface.geometry,
        materials=surface.material_indices,
        parent_from_object=matrix,
    )


def _include(content: Content, inner: Content, name: str, matrices: Matrices) -> None:
    """Adds copies of `inner` to `content`, one for each matrix."""
    if not len(matrices):
        return
    for prim, matrix in inner.lights:
        content.lights.extend((prim, outer @ matrix) for outer in matrices)
    for placement in inner.placements:
        composed = matrices[:, np.newaxis] @ placement.matrices[np.newaxis]
        content.placements.append(Placement(placement.group, name, composed.reshape(-1, 4, 4)))
