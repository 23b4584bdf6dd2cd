"""python -m parity: see README.md."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Protocol, TypeVar

from parity import closed_form, correctness, speed
from parity.cases import CASES, SKY, Case
from parity.races import RACES, Race
from parity.sky import write_sky
from support.marked_table import replace_between_markers

ROOT = Path(__file__).parents[2]
WORK = ROOT / "build" / "parity"
PARITY_TABLE = ROOT / "tests" / "parity" / "README.md"
SPEED_TABLE = ROOT / "tests" / "bench" / "README.md"


def main() -> int:
    """Returns 1 unless all renderers agree."""
    parser = _parser()
    arguments = parser.parse_args()
    if arguments.write and arguments.effort != 1:
        parser.error("--write wants full effort")
    if (
        arguments.write
        and arguments.speed
        and arguments.only
        and not speed.is_of_this_machine(SPEED_TABLE)
    ):
        parser.error(f"the table of {SPEED_TABLE} is of another machine: write all of it")
    try:
        if arguments.closed_form:
            run_closed_form(arguments.write)
            return 0
        if arguments.speed:
            run_speed(_named(RACES, arguments.only), arguments.effort, arguments.write)
            return 0
        cases = _named(CASES, arguments.only)
    except LookupError as error:
        parser.error(str(error))
    return run_correctness(cases, arguments.effort, arguments.pictures, arguments.write)


def run_closed_form(write: bool) -> None:
    """Compares with what is known exactly."""
    text = closed_form.results_table(WORK)
    print(text)
    if write:
        replace_between_markers(PARITY_TABLE, "closed form", text)


def run_correctness(
    cases: Sequence[Case], effort: float, pictures: Path | None, write: bool
) -> int:
    """Compares pictures. What is written is written case by case: the whole takes a while."""
    write_sky(SKY)
    if pictures is not None:
        pictures.mkdir(parents=True, exist_ok=True)
    disagreements = 0
    for case in cases:
        started = time.perf_counter()
        rows = []
        for peer, comparison in correctness.check(case, effort, pictures):
            rows.append(correctness.row(case, peer, comparison))
            print(" | ".join(rows[-1]), flush=True)
            disagreements += comparison.verdict != "agrees"
        print(f"  {time.perf_counter() - started:.0f} s", flush=True)
        if write:
            correctness.write(PARITY_TABLE, rows)
    return 1 if disagreements else 0


def run_speed(races: Sequence[Race], effort: float, write: bool) -> None:
    """Races."""
    for race in races:
        started = time.perf_counter()
        rows = speed.rows(race, speed.run(race, effort))
        print("\n".join(" | ".join(row) for row in rows), flush=True)
        print(f"  {time.perf_counter() - started:.0f} s", flush=True)
        if write:
            speed.write(SPEED_TABLE, rows)


class _Named(Protocol):
    @property
    def name(self) -> str: ...


N = TypeVar("N", bound=_Named)


def _named(known: Sequence[N], part: str) -> list[N]:
    """Those whose name contains it. Raises LookupError when there are none."""
    found = [one for one in known if part in one.name]
    if not found:
        names = "; ".join(one.name for one in known)
        raise LookupError(f"--only {part}: no such name; there are: {names}")
    return found


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="./etendue test parity", description="Compares Etendue with Mitsuba 3 and LuxCore."
    )
    parser.add_argument("--speed", action="store_true", help="efficiency instead of agreement")
    parser.add_argument("--only", metavar="NAME", default="", help="rows whose name contains it")
    parser.add_argument(
        "--closed-form", action="store_true", help="who is right where others disagree"
    )
    parser.add_argument(
        "--effort", metavar="X", type=float, default=1.0, help="multiplies the samples (default 1)"
    )
    parser.add_argument(
        "--write", action="store_true", help="puts the rows into the table in the README"
    )
    parser.add_argument("--pictures", metavar="DIR", type=Path, help="keeps mean images as .npy")
    return parser


if __name__ == "__main__":
    sys.exit(main())
