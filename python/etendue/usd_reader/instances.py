"""Native instances and point instancers: which copies share, and where they stand."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt
from pxr import Sdf, Tf, Usd, UsdGeom

from etendue.usd_reader.context import ReadContext

NativeKey = tuple[object, ...]


class NativeKeys:
    """Keys of native instances: equal keys look the same but for their transform.

    What an instance inherits from outside its prototype takes part: material bindings, constant
    primvars and purpose.
    """

    def __init__(self) -> None:
        self._inherited: dict[Sdf.Path, NativeKey] = {}

    def key(self, prim: Usd.Prim, purpose: str) -> NativeKey:
        """The key of an instance prim whose inheritable purpose is `purpose`."""
        prototype = str(prim.GetPrototype().GetPath())
        if prim.IsA(UsdGeom.Gprim):  # its own attributes differ from instance to instance
            return (prototype, str(prim.GetPath()))
        return (prototype, purpose, self._inherits(prim))

    def _inherits(self, prim: Usd.Prim) -> NativeKey:
        """Bindings and primvars of `prim` and its ancestors."""
        if prim.IsPseudoRoot():
            return ()
        path = prim.GetPath()
        if path not in self._inherited:
            own: list[object] = []
            for name in prim.GetAuthoredPropertyNames():
                if name.startswith("material:binding"):
                    own.append(_binding(prim, name))
                elif name.startswith("primvars:"):
                    attribute = prim.GetAttribute(name)
                    if attribute:
                        own.append((name, repr(attribute.Get()), attribute.GetNumTimeSamples()))
            outer = self._inherits(prim.GetParent())
            self._inherited[path] = (outer, *own) if own else outer
        return self._inherited[path]


def _binding(prim: Usd.Prim, name: str) -> NativeKey:
    relationship = prim.GetRelationship(name)
    if not relationship:
        return (name,)
    if name.startswith("material:binding:collection"):
        # A collection may reach some prims inside one instance and none inside another.
        return (name, str(prim.GetPath()))
    targets = tuple(str(target) for target in relationship.GetForwardedTargets())
    return (name, targets, str(relationship.GetMetadata("bindMaterialAs")))


def point_instances(
    context: ReadContext, prim: Usd.Prim
) -> Iterator[tuple[Usd.Prim, npt.NDArray[np.float64]]]:
    """For each prototype its copies' matrices (n, 4, 4), prototype root to instancer.

    Inactive and invisible ids are left out. An instancer whose attributes contradict each other is
    skipped with a warning.
    """
    instancer = UsdGeom.PointInstancer(prim)
    time = context.time
    prototypes = [
        context.stage.GetPrimAtPath(target)
        for target in instancer.GetPrototypesRel().GetForwardedTargets()
    ]
    indices = np.asarray(instancer.GetProtoIndicesAttr().Get(time) or [], dtype=np.int64)
    for index in np.unique(indices):
        if not 0 <= index < len(prototypes) or not prototypes[index]:
            _skip(context, instancer, f"prototype {index} of {len(prototypes)} does not exist")
            return
    matrices = _matrices(context, instancer, len(indices))
    if matrices is None:
        return
    mask = np.asarray(instancer.ComputeMaskAtTime(time) or np.ones(len(indices)), dtype=bool)
    for index in np.unique(indices[mask]):
        yield prototypes[index], matrices[mask & (indices == index)]


def _matrices(
    context: ReadContext, instancer: UsdGeom.PointInstancer, count: int
) -> npt.NDArray[np.float64] | None:
    try:
        value = instancer.ComputeInstanceTransformsAtTime(
            context.time,
            context.time,
            UsdGeom.PointInstancer.IncludeProtoXform,
            UsdGeom.PointInstancer.IgnoreMask,
        )
    except Tf.ErrorException:
        value = []
    matrices = np.asarray(value, dtype=np.float64).reshape(-1, 4, 4)
    if len(matrices) != count or not count:
        _skip(
            context,
            instancer,
            "its positions, orientations, scales and protoIndices do not match"
            if count
            else "it has no instances",
        )
        return None
    if not np.isfinite(matrices).all():
        _skip(context, instancer, "not all of its transforms are finite")
        return None
    return matrices.transpose(0, 2, 1)


def _skip(context: ReadContext, instancer: UsdGeom.PointInstancer, reason: str) -> None:
    context.report.warn(
        f"unusable point instancer {instancer.GetPath()}",
        instancer.GetPath(),
        f"the point instancer is skipped: {reason}",
    )
