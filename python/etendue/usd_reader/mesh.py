"""UsdGeomMesh to MeshDesc: topology checked, holes cut out, primvars flattened."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
import numpy.typing as npt
from pxr import Usd, UsdGeom

from etendue import _core
from etendue.usd_reader.context import ReadContext
from etendue.usd_reader.primvars import PrimvarValues, read_primvar

_Floats = npt.NDArray[np.float32]
_Ints = npt.NDArray[np.int32]
_Mask = npt.NDArray[np.bool_]
_Scalar = TypeVar("_Scalar", bound=np.generic)

_INTERPOLATIONS = {
    "constant": _core.Interpolation.Constant,
    "uniform": _core.Interpolation.Uniform,
    "varying": _core.Interpolation.Vertex,  # on a mesh: one value per point, too
    "vertex": _core.Interpolation.Vertex,
    "faceVarying": _core.Interpolation.FaceVarying,
}


class UnusableMeshError(Exception):
    """Why a mesh cannot be rendered."""


@dataclass(frozen=True)
class Topology:
    """Faces as authored, before any is dropped."""

    counts: _Ints
    indices: _Ints

    @property
    def corner_faces(self) -> _Ints:
        """For each corner its face."""
        return np.repeat(np.arange(len(self.counts), dtype=np.int32), self.counts)


def read_mesh(
    context: ReadContext, prim: Usd.Prim, st_name: str | None, face_materials: _Ints | None
) -> _core.MeshDesc | None:
    """The mesh, or None (after a warning that names the prim and the reason) when it is unusable.

    Without a `st_name` no texture coordinates are read. `face_materials` has one entry per authored
    face.
    """
    mesh = UsdGeom.Mesh(prim)
    try:
        points = _points(context, mesh)
        topology = _topology(context, mesh, len(points))
        kept = _kept_faces(context, mesh, topology)
    except UnusableMeshError as reason:
        context.report.warn(
            f"unusable mesh {prim.GetPath()}", prim.GetPath(), f"the mesh is skipped: {reason}"
        )
        return None

    desc = _core.MeshDesc(
        points=points,
        face_vertex_counts=_of_kept(topology.counts, kept),
        face_vertex_indices=_of_kept_corners(topology.indices, topology, kept),
        left_handed=mesh.GetOrientationAttr().Get(context.time) == UsdGeom.Tokens.leftHanded,
    )
    if face_materials is not None:
        desc.face_materials = face_materials[kept]
    _set_normals(context, mesh, topology, points, kept, desc)
    if st_name is not None:
        _set_st(context, prim, st_name, topology, len(points), kept, desc)
    return desc


def _points(context: ReadContext, mesh: UsdGeom.Mesh) -> _Floats:
    value = mesh.GetPointsAttr().Get(context.time)
    points = np.asarray(value if value is not None else [], dtype=np.float32).reshape(-1, 3)
    if not len(points):
        raise UnusableMeshError("it has no points")
    if not np.isfinite(points).all():
        bad = int(np.flatnonzero(~np.isfinite(points).all(axis=1))[0])
        raise UnusableMeshError(f"point {bad} is not finite")
    return points


def _topology(context: ReadContext, mesh: UsdGeom.Mesh, point_count: int) -> Topology:
    counts = _integers(mesh.GetFaceVertexCountsAttr().Get(context.time))
    indices = _integers(mesh.GetFaceVertexIndicesAttr().Get(context.time))
    if not len(counts):
        raise UnusableMeshError("it has no faces")
    if counts.min() < 0:
        raise UnusableMeshError("a face has a negative number of corners")
    corners = int(counts.sum(dtype=np.int64))
    if corners != len(indices):
        raise UnusableMeshError(
            f"faceVertexCounts add up to {corners} but there are {len(indices)} faceVertexIndices"
        )
    if len(indices) and (indices.min() < 0 or indices.max() >= point_count):
        bad = int(indices.min()) if indices.min() < 0 else int(indices.max())
        raise UnusableMeshError(f"index {bad} is out of range for {point_count} points")
    return Topology(counts, indices)


def _kept_faces(context: ReadContext, mesh: UsdGeom.Mesh, topology: Topology) -> _Mask:
    kept: _Mask = topology.counts >= 3
    if not kept.all():
        context.report.warn(
            "faces of fewer than three corners",
            mesh.GetPath(),
            f"{np.count_nonzero(~kept)} faces of fewer than three corners are left out",
        )
    holes = _integers(mesh.GetHoleIndicesAttr().Get(context.time))
    valid = (holes >= 0) & (holes < len(kept))
    if not valid.all():
        context.report.warn(
            f"hole indices {mesh.GetPath()}",
            mesh.GetPath(),
            "holeIndices out of range are ignored",
        )
    kept[holes[valid]] = False
    if not kept.any():
        raise UnusableMeshError("no face is left")
    return kept


def _of_kept(values: npt.NDArray[_Scalar], kept: _Mask) -> npt.NDArray[_Scalar]:
    """One value per face. Nothing is copied where all faces stay, which is the usual case."""
    return values if kept.all() else values[kept]


def _of_kept_corners(
    values: npt.NDArray[_Scalar], topology: Topology, kept: _Mask
) -> npt.NDArray[_Scalar]:
    """One value per corner."""
    return values if kept.all() else values[kept[topology.corner_faces]]


# -------------------------------------------------------------------------------------- primvars


def _set_normals(
    context: ReadContext,
    mesh: UsdGeom.Mesh,
    topology: Topology,
    points: _Floats,
    kept: _Mask,
    desc: _core.MeshDesc,
) -> None:
    prim = mesh.GetPrim()
    flat = _interpolated(
        context, prim, "normals", _authored_normals(context, mesh), 3, topology, len(points), kept
    )
    scheme = str(mesh.GetSubdivisionSchemeAttr().Get())
    if scheme in (UsdGeom.Tokens.catmullClark, UsdGeom.Tokens.loop):
        used = "its authored normals" if flat else "smooth normals"
        context.report.warn(
            f"subdivision {scheme} with {used}",
            prim.GetPath(),
            f"subdivisionScheme '{scheme}' is not supported; the control cage is rendered with "
            f"{used} (author subdivisionScheme 'none' for a polygon mesh)",
        )
        if not flat:
            flat = (_smooth_normals(points, topology, desc.left_handed), "vertex")
    if flat:
        desc.normals = flat[0]
        desc.normals_interpolation = _INTERPOLATIONS[flat[1]]


def _set_st(
    context: ReadContext,
    prim: Usd.Prim,
    name: str,
    topology: Topology,
    point_count: int,
    kept: _Mask,
    desc: _core.MeshDesc,
) -> None:
    primvar = read_primvar(context, prim, name)
    flat = _interpolated(context, prim, name, primvar, 2, topology, point_count, kept)
    if flat:
        desc.st = flat[0]
        desc.st_interpolation = _INTERPOLATIONS[flat[1]]


def _authored_normals(context: ReadContext, mesh: UsdGeom.Mesh) -> PrimvarValues | None:
    """primvars:normals, which wins, or the normals attribute."""
    primvar = read_primvar(context, mesh.GetPrim(), "normals")
    if primvar is not None:
        return primvar
    attribute = mesh.GetNormalsAttr()
    value = attribute.Get(context.time)
    if value is None or not len(value):
        return None
    values = np.asarray(value, dtype=np.float64).reshape(-1, 3)
    if not np.isfinite(values).all():
        context.report.warn(
            f"normals {mesh.GetPath()}",
            mesh.GetPath(),
            "the normals are ignored: not all of them are finite",
        )
        return None
    return PrimvarValues(attribute, values, str(mesh.GetNormalsInterpolation()))


def _interpolated(
    context: ReadContext,
    prim: Usd.Prim,
    name: str,
    primvar: PrimvarValues | None,
    channels: int,
    topology: Topology,
    point_count: int,
    kept: _Mask,
) -> tuple[_Floats, str] | None:
    """The values that belong to the kept faces, and their interpolation; None when unusable."""
    if primvar is None:
        return None
    values, interpolation = primvar.values, primvar.interpolation
    expected = {
        "constant": 1,
        "uniform": len(topology.counts),
        "varying": point_count,
        "vertex": point_count,
        "faceVarying": len(topology.indices),
    }.get(interpolation)
    # An array of texture coordinates may carry a third, unused component.
    if expected != len(values) or values.shape[1] < channels:
        context.report.warn(
            f"primvar length {prim.GetPath()} {name}",
            prim.GetPath(),
            f"'{name}' is ignored: {len(values)} values of {values.shape[1]} numbers for "
            f"interpolation '{interpolation}', which needs {expected} of {channels}",
        )
        return None
    if interpolation == "uniform":
        values = _of_kept(values, kept)
    elif interpolation == "faceVarying":
        values = _of_kept_corners(values, topology, kept)
    return values[:, :channels].astype(np.float32), interpolation


def _smooth_normals(points: _Floats, topology: Topology, left_handed: bool) -> _Floats:
    """Unit normals at the points: the area-weighted mean of the faces around each."""
    ends = np.cumsum(topology.counts)
    starts = ends - topology.counts
    following = np.arange(1, len(topology.indices) + 1)
    nonempty = topology.counts > 0
    following[ends[nonempty] - 1] = starts[nonempty]
    corners = points[topology.indices].astype(np.float64)
    # Newell: the sum over a face's edges of p x p' is twice its vector area.
    edge_terms = np.cross(corners, corners[following])
    areas = np.zeros((len(topology.counts), 3))
    np.add.at(areas, topology.corner_faces, edge_terms)
    normals = np.zeros((len(points), 3))
    np.add.at(normals, topology.indices, areas[topology.corner_faces])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    unit: _Floats = (-normals if left_handed else normals).astype(np.float32)
    return unit


def _integers(value: object) -> _Ints:
    return np.asarray([] if value is None else value, dtype=np.int32).reshape(-1)
