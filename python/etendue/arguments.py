"""Arguments that commands share."""

from __future__ import annotations

import re
import sys
import warnings
from typing import Annotated, Any

import typer

from etendue.exceptions import EtendueWarning
from etendue.stage import Stage, open_stage

StageArgument = Annotated[str, typer.Argument(metavar="STAGE", help="A USD file.")]
FrameOption = Annotated[
    float | None, typer.Option("--frame", help="Time code to read; default: the stage's start.")
]


def open_named(stage: str, frame: float | None, *, quiet: bool = False) -> Stage:
    """With the reader's warnings as lines on stderr, or without any."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", EtendueWarning)
        opened = open_stage(stage, frame=frame)
    if not quiet:
        for warning in opened.warnings:
            print(f"etendue: warning: {warning}", file=sys.stderr)
    return opened


def numbers(option: str, text: str | None, separator: str, count: int) -> Any:
    """'640x480' to (640, 480); None for None."""
    if text is None:
        return None
    parts = re.split(separator, text.strip().lower())
    if len(parts) != count or not all(re.fullmatch(r"\s*-?\d+\s*", part) for part in parts):
        form = "WIDTHxHEIGHT" if count == 2 else "X0,Y0,X1,Y1"
        raise typer.BadParameter(f"--{option} wants {form}, not '{text}'")
    return tuple(int(part) for part in parts)
