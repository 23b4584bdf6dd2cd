"""A stage with some of its values changed, the file left alone."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from pxr import Tf, Usd

from etendue import _core
from etendue.usd_reader.stage import open_usd


def open_edited(
    file: str | os.PathLike[str],
    variants: Mapping[str, str],
    values: Mapping[str, object],
) -> Usd.Stage:
    """Opens a USD file and changes it in its session layer, which is not saved.

    `variants` are choices by "/prim{set}", `values` are attributes by "/prim.attribute"; None takes
    an attribute's value and connections away. Raises FileError for the file, SceneError naming file
    and place for what the stage does not have, and for a value of another type.
    """
    stage, source = open_usd(file)
    with Usd.EditContext(stage, stage.GetSessionLayer()):
        for place, choice in variants.items():
            _choose(stage, source, place, choice)
        for place, value in values.items():
            _set(stage, source, place, value)
    return stage


def _choose(stage: Usd.Stage, source: str, place: str, choice: str) -> None:
    prim, _, name = place.removesuffix("}").partition("{")
    sets = _prim(stage, source, prim).GetVariantSets()
    if not sets.HasVariantSet(name) or choice not in sets.GetVariantSet(name).GetVariantNames():
        raise _core.SceneError(f"{source}: <{place}> has no variant '{choice}'")
    sets.GetVariantSet(name).SetVariantSelection(choice)


def _set(stage: Usd.Stage, source: str, place: str, value: object) -> None:
    prim, _, name = place.partition(".")
    holder = _prim(stage, source, prim)
    attribute: Any = holder.GetAttribute(name) if name else None
    if not attribute:
        raise _core.SceneError(f"{source}: <{place}> does not exist")
    if value is None:
        attribute.Block()
        attribute.SetConnections([])
        return
    try:
        attribute.Set(value)
    except Tf.ErrorException as error:  # of another type
        raise _core.SceneError(f"{source}: <{place}> cannot be {value!r}") from error


def _prim(stage: Usd.Stage, source: str, path: str) -> Usd.Prim:
    prim = stage.GetPrimAtPath(path)
    if not prim:
        raise _core.SceneError(f"{source}: <{path}> does not exist")
    return prim
