"""Primvars resolved: inheritance, indices, time; values as arrays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from pxr import Usd, UsdGeom

from etendue.usd_reader.context import ReadContext


@dataclass(frozen=True)
class PrimvarValues:
    """(n, k) values without indices; `interpolation` is a USD token."""

    attribute: Usd.Attribute
    values: npt.NDArray[np.float64]
    interpolation: str


def read_primvar(context: ReadContext, prim: Usd.Prim, name: str) -> PrimvarValues | None:
    """The primvar as it applies to `prim`, inherited ones too; None without a usable value."""
    primvar = UsdGeom.PrimvarsAPI(prim).FindPrimvarWithInheritance(name)
    if not primvar or not primvar.HasValue():
        return None
    value = primvar.Get(context.time)
    if value is None:
        return None
    try:
        values = np.atleast_1d(np.asarray(value, dtype=np.float64))
    except (TypeError, ValueError):
        context.report.warn(
            f"primvar type {prim.GetPath()} {name}",
            prim.GetPath(),
            f"primvar '{name}' is ignored: its values are not numbers",
        )
        return None
    if not primvar.GetTypeName().isArray:
        values = values[np.newaxis]
    if values.ndim == 1:
        values = values[:, np.newaxis]
    if primvar.IsIndexed():
        indices = np.asarray(primvar.GetIndices(context.time), dtype=np.int64)
        if indices.size and (indices.min() < 0 or indices.max() >= len(values)):
            context.report.warn(
                f"primvar indices {prim.GetPath()} {name}",
                prim.GetPath(),
                f"primvar '{name}' is ignored: an index is out of range",
            )
            return None
        values = values[indices]
    if not np.isfinite(values).all():
        context.report.warn(
            f"primvar values {prim.GetPath()} {name}",
            prim.GetPath(),
            f"primvar '{name}' is ignored: not all of its values are finite numbers",
        )
        return None
    return PrimvarValues(primvar.GetAttr(), values, str(primvar.GetInterpolation()))
