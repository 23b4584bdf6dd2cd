"""etendue validate, on the command line."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from etendue.exceptions import ValidationInterrupted
from etendue.exit_status import DIFFERENT, INTERRUPTED
from etendue.progress import duration, step_progress
from etendue.report_folder import check_report
from etendue.validation.report import summary_table, write_report
from etendue.validation.report.verdicts import verdict
from etendue.validation.results import Check, ValidationResult
from etendue.validation.runner import case_names, validate


def validate_command(
    out: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Write index.html, results.json and results.csv there."),
    ] = None,
    full: Annotated[
        bool,
        typer.Option("--full/--quick", help="Quick: 3 minutes on 2 cores; full: 20."),
    ] = False,
    case: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME", help=f"Repeatable; default: all. {', '.join(case_names())}"),
    ] = None,
    seed: Annotated[int, typer.Option(help="The same seed gives the same figures.")] = 1,
) -> int:
    """Show what goes wrong without the adjoint corrections: predicted, and measured.

    Ctrl-C tells of, and writes, the cases that have finished. Ends with 3 when a prediction fails.
    """
    if out is not None:
        check_report(out)
    status = None
    with step_progress("validating") as progress:
        try:
            result = validate(
                case, effort="full" if full else "quick", seed=seed, progress=progress
            )
        except ValidationInterrupted as interruption:
            status, result = INTERRUPTED, interruption.result
    console = Console(highlight=False)
    console.print(summary_table(result))
    for line in _told(result):
        console.print(line, markup=False, soft_wrap=True)
    if out is not None:
        print(f"wrote {write_report(result, out)}", file=sys.stderr)
    if status is not None:
        return status
    return 0 if result.passed else DIFFERENT


def _told(result: ValidationResult) -> Iterator[str]:
    """The outcome in plain words."""
    for case in result.cases:
        for check in case.checks:
            if not check.passed:
                yield f"failed: {case.name}: {_failure(check)}"
    for error in result.diagnoses:
        yield f"this explains it: {error}"
    yield f"{verdict(result)}, {duration(result.seconds)}"


def _failure(check: Check) -> str:
    measured = check.measured
    told = (
        f"{check.name}: {check.quantity} is {measured.value:.4g} "
        f"({measured.low:.4g} to {measured.high:.4g}), predicted {check.predicted:.4g}"
    )
    return f"{told}; {' or '.join(check.explanations)}" if check.explanations else told
