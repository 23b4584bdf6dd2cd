"""etendue tradeoff, on the command line."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from etendue.arguments import FrameOption, StageArgument, numbers, open_named
from etendue.exceptions import TradeoffInterrupted
from etendue.exit_status import INTERRUPTED
from etendue.progress import step_progress
from etendue.report_folder import check_report
from etendue.tradeoff.candidates import candidate_names
from etendue.tradeoff.report import summary_table, write_report
from etendue.tradeoff.report.words import (
    cannot_be_concluded,
    headline,
    seconds_text,
    verdict_sentence,
)
from etendue.tradeoff.results import TradeoffResult
from etendue.tradeoff.runner import TIME, WIDTH, tradeoff


def tradeoff_command(
    stage: StageArgument,
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            help="For index.html, results.json and results.csv; default: STAGE-tradeoff.",
        ),
    ] = None,
    camera: Annotated[
        str | None, typer.Option(help="Prim path or name; default: the render settings', or first.")
    ] = None,
    frame: FrameOption = None,
    resolution: Annotated[
        str | None,
        typer.Option(
            metavar="WxH", help=f"Default: the reference file's, or at most {WIDTH}x{WIDTH}."
        ),
    ] = None,
    time: Annotated[
        float,
        typer.Option(metavar="SECONDS", help="All renders together, on a machine of their own."),
    ] = TIME,
    only: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME", help=f"Repeatable; default: all. {', '.join(candidate_names())}"
        ),
    ] = None,
    reference: Annotated[
        str | None,
        typer.Option(metavar="FILE.exr", help="Measure by it; default: by a long render of bdpt."),
    ] = None,
    seed: Annotated[int, typer.Option(help="The same seed gives the same pictures.")] = 1,
) -> int:
    """Measure how good a picture each way to render the stage gives in how much time.

    Writes a page that shows it, and the figures. All are rendered in turn, in rounds; Ctrl-C tells
    of, and writes, the rounds that have finished.
    """
    size = numbers("resolution", resolution, "x", 2)
    opened = open_named(stage, frame)
    folder = out if out is not None else Path(f"{Path(stage).stem}-tradeoff")
    check_report(folder)
    status = 0
    with step_progress("measuring") as progress:
        try:
            result = tradeoff(
                opened,
                camera=camera,
                resolution=size,
                time=time,
                seed=seed,
                only=only,
                reference=reference,
                progress=progress,
            )
        except TradeoffInterrupted as interruption:
            status, result = INTERRUPTED, interruption.result
    _tell(result)
    print(f"wrote {write_report(result, folder)}", file=sys.stderr)
    return status


def _tell(result: TradeoffResult) -> None:
    """The outcome in plain words."""
    console = Console(highlight=False)
    console.print(summary_table(result))
    console.print(headline(result), markup=False, soft_wrap=True)
    for found in result.candidates:
        if found.verdict != "converges":
            line = f"{found.name}: {verdict_sentence(found)}"
            console.print(line, markup=False, soft_wrap=True)
    for choice in result.choices:
        asked_for = result[choice.best].candidate.asked_for
        line = f"with {seconds_text(choice.seconds)}: {choice.best} ({asked_for})"
        console.print(line, markup=False, soft_wrap=True)
    for caution in cannot_be_concluded(result):
        console.print(f"note: {caution}", markup=False, soft_wrap=True)
