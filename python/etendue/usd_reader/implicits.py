"""Sphere, Cube, Cylinder, Cone, Capsule and Plane."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from pxr import Usd

from etendue import _core
from etendue.usd_reader.context import ReadContext

_Solid = (
    _core.SphereDesc
    | _core.CubeDesc
    | _core.CylinderDesc
    | _core.ConeDesc
    | _core.CapsuleDesc
    | _core.PlaneDesc
)
_AXES = {"X": _core.Axis.X, "Y": _core.Axis.Y, "Z": _core.Axis.Z}


def read_implicit(context: ReadContext, prim: Usd.Prim) -> _Solid | None:
    """The solid, or None when `prim` is not one of them."""
    reader = _READERS.get(str(prim.GetTypeName()))
    return reader(context, prim) if reader else None


def _value(context: ReadContext, prim: Usd.Prim, name: str) -> Any:
    return prim.GetAttribute(name).Get(context.time)


def _axis(context: ReadContext, prim: Usd.Prim) -> _core.Axis:
    token = str(_value(context, prim, "axis"))
    if token not in _AXES:
        context.report.warn(f"axis {token}", prim.GetPath(), f"unknown axis '{token}'; 'Z' is used")
    return _AXES.get(token, _core.Axis.Z)


def _sphere(context: ReadContext, prim: Usd.Prim) -> _core.SphereDesc:
    return _core.SphereDesc(radius=_value(context, prim, "radius"))


def _cube(context: ReadContext, prim: Usd.Prim) -> _core.CubeDesc:
    return _core.CubeDesc(size=_value(context, prim, "size"))


def _cylinder(context: ReadContext, prim: Usd.Prim) -> _core.CylinderDesc:
    return _core.CylinderDesc(
        radius=_radius(context, prim),
        height=_value(context, prim, "height"),
        axis=_axis(context, prim),
    )


def _cone(context: ReadContext, prim: Usd.Prim) -> _core.ConeDesc:
    return _core.ConeDesc(
        radius=_value(context, prim, "radius"),
        height=_value(context, prim, "height"),
        axis=_axis(context, prim),
    )


def _capsule(context: ReadContext, prim: Usd.Prim) -> _core.CapsuleDesc:
    return _core.CapsuleDesc(
        radius=_radius(context, prim),
        height=_value(context, prim, "height"),
        axis=_axis(context, prim),
    )


def _plane(context: ReadContext, prim: Usd.Prim) -> _core.PlaneDesc:
    return _core.PlaneDesc(
        width=_value(context, prim, "width"),
        length=_value(context, prim, "length"),
        axis=_axis(context, prim),
    )


def _radius(context: ReadContext, prim: Usd.Prim) -> float:
    """The radius, or the mean of the two of a _1 schema when they differ."""
    if prim.HasAttribute("radius"):
        return float(_value(context, prim, "radius"))
    top = float(_value(context, prim, "radiusTop"))
    bottom = float(_value(context, prim, "radiusBottom"))
    if top != bottom:
        context.report.warn(
            "tapered solid",
            prim.GetPath(),
            f"a {prim.GetTypeName()} with two radii is not supported; their mean is used",
        )
    return (top + bottom) / 2


_READERS: dict[str, Callable[[ReadContext, Usd.Prim], _Solid]] = {
    "Sphere": _sphere,
    "Cube": _cube,
    "Cylinder": _cylinder,
    "Cylinder_1": _cylinder,
    "Cone": _cone,
    "Capsule": _capsule,
    "Capsule_1": _capsule,
    "Plane": _plane,
}
