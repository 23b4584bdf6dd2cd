"""A USD stage, at a time code, as a SceneDescription."""

from __future__ import annotations

import os
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import TypeAlias

from pxr import Tf, Usd, UsdUtils

from etendue import _core
from etendue.usd_reader.camera import read_cameras
from etendue.usd_reader.context import ReadContext, Scratch
from etendue.usd_reader.products import StageSettings, read_settings
from etendue.usd_reader.report import StageWarning
from etendue.usd_reader.walk import StageWalk

StageLike: TypeAlias = str | os.PathLike[str] | Usd.Stage


@dataclass(frozen=True)
class StageContents:
    """What was read: the scene, what the stage asks of a render, and what was left out."""

    source: str
    frame: float
    prims: dict[str, int]  # by type name, inactive and abstract prims left out
    scene: _core.SceneDescription
    settings: StageSettings
    cameras: tuple[str, ...]
    warnings: tuple[StageWarning, ...]
    scratch: Scratch  # textures of the scene may live in it


def read_stage(path_or_stage: StageLike, frame: float | None = None) -> StageContents:
    """Reads a stage, or the stage in a file, at a frame (default: its startTimeCode).

    Raises FileError naming the file when there is none or it is not a stage.
    """
    stage, source = open_usd(path_or_stage)
    if frame is None:
        frame = float(stage.GetStartTimeCode())
    context = ReadContext(stage=stage, time=Usd.TimeCode(frame), source=source)
    context.scene.source = source
    _report_composition(context)
    # USD prints its own warnings on stderr; they are reported with ours instead.
    delegate = UsdUtils.CoalescingDiagnosticDelegate()
    settings = read_settings(context)
    context.purposes = settings.purposes
    context.material_purpose = settings.material_purpose
    cameras = read_cameras(context, depth_of_field=settings.depth_of_field)
    StageWalk(context).run()
    for diagnostic in delegate.TakeUncoalescedDiagnostics():
        text = str(diagnostic.commentary)
        context.report.warn(f"usd {text}", source, text)
    return StageContents(
        source=source,
        frame=frame,
        prims=dict(Counter(str(prim.GetTypeName()) for prim in stage.Traverse())),
        scene=context.scene,
        settings=settings,
        cameras=cameras,
        warnings=context.report.warnings,
        scratch=context.scratch,
    )


def open_usd(path_or_stage: StageLike) -> tuple[Usd.Stage, str]:
    """The stage and what to call it. Raises FileError when there is none, or it is not a stage."""
    if isinstance(path_or_stage, Usd.Stage):
        layer = path_or_stage.GetRootLayer()
        return path_or_stage, str(layer.realPath or layer.identifier)
    path = Path(path_or_stage)
    if not path.exists():
        raise _core.FileError(f"{path}: no such file")
    if path.is_dir():
        raise _core.FileError(f"{path}: is a directory, not a stage")
    try:
        delegate = UsdUtils.CoalescingDiagnosticDelegate()
        stage = Usd.Stage.Open(str(path))
        delegate.TakeUncoalescedDiagnostics()
    except Tf.ErrorException as error:
        raise _core.FileError(f"{path}: not a USD stage: {_first_reason(error)}") from None
    if not stage:
        raise _core.FileError(f"{path}: not a USD stage")
    return stage, str(path)


def _report_composition(context: ReadContext) -> None:
    """References and the like that lead nowhere."""
    for error in context.stage.GetCompositionErrors():
        text = str(error).rstrip(".")
        if ".mtlx@" in text:
            text += " (this build of USD does not read .mtlx files)"
        context.report.warn(f"composition {text}", error.rootSite.path, text)


def _first_reason(error: Tf.ErrorException) -> str:
    """USD's own words, without its source location, on one line."""
    reasons = [line.rsplit(" : ", 1)[-1] for line in str(error).splitlines() if line.strip()]
    return reasons[0].strip().strip("'") if reasons else "unknown reason"
