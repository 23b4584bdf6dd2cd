"""Efficiency of renderers on the same picture, taken in turn.

Efficiency is 1 / (relMSE x CPU seconds): what a second buys, whatever the number of samples.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from parity.plain_scene import Floats
from parity.processes import RendererProcess
from parity.races import RACES, Race, Runner
from parity.tasks import Picture
from support.machine import machine
from support.marked_table import Row, between_markers, replace_between_markers, table, table_rows
from support.rel_mse import RelMse, rel_mse

ROUNDS = 5


@dataclass(frozen=True)
class Efficiency:
    """Of one runner."""

    runner: Runner
    cpu: float  #: seconds per render
    wall: float  #: seconds per render
    error: RelMse

    @property
    def efficiency(self) -> float:
        """Per CPU second."""
        return 1 / (self.error.whole * self.cpu)

    @property
    def robust_efficiency(self) -> float:
        """Per CPU second."""
        return 1 / (self.error.robust * self.cpu)


def run(race: Race, effort: float) -> list[Efficiency]:
    """Every runner's efficiency; `effort` multiplies the samples."""
    reference = _reference(race, effort)
    pictures: dict[Runner, list[Picture]] = {runner: [] for runner in race.runners}
    with ExitStack() as stack:
        processes = {
            runner: stack.enter_context(RendererProcess(race.case.task(runner.method, race.width)))
            for runner in race.runners
        }
        for turn in range(ROUNDS + 1):
            for runner, process in processes.items():
                picture = process.render(_samples(runner.spp, effort), 1000 + turn)
                if turn > 0:  # the first warms caches up and compiles
                    pictures[runner].append(picture)
    return [_efficiency(runner, taken, reference) for runner, taken in pictures.items()]


def _samples(spp: int, effort: float) -> int:
    return max(1, round(spp * effort))


def _reference(race: Race, effort: float) -> Floats:
    with RendererProcess(race.case.task(race.reference, race.width)) as process:
        return process.render(_samples(race.reference_spp, effort), 1).image


def _efficiency(runner: Runner, pictures: list[Picture], reference: Floats) -> Efficiency:
    return Efficiency(
        runner=runner,
        cpu=float(np.mean([picture.cpu for picture in pictures])),
        wall=float(np.mean([picture.wall for picture in pictures])),
        error=rel_mse([picture.image for picture in pictures], reference),
    )


# --- table ----------------------------------------------------------------------------------------

HEAD = (
    "race",
    "stage",
    "depth",
    "who",
    "CPU s",
    "wall s",
    "relMSE",
    "efficiency",
    "ratio (robust)",
    "bar",
)


def rows(race: Race, results: list[Efficiency]) -> list[Row]:
    """Of the table: ours with the ratio, then the others."""
    ours, others = results[0], results[1:]
    ratio = ours.efficiency / max(other.efficiency for other in others)
    robust = ours.robust_efficiency / max(other.robust_efficiency for other in others)
    cells = [_cells(result) for result in results]
    name = (race.name, race.case.stage.file.stem, str(race.case.max_depth))
    first = (*name, *cells[0], f"**{ratio:.2f}** ({robust:.2f})", f"{race.bar:g}")
    return [first, *(("", "", "", *other, "", "") for other in cells[1:])]


def write(document: Path, rows: Sequence[Row]) -> None:
    """Puts a race's rows into the document's table, beside the other races of this machine."""
    known = table_rows(between_markers(document, "speed")) if is_of_this_machine(document) else []
    races: dict[str, list[Row]] = {}
    for row in known:
        # Only the first row of a race names it.
        name = row[0] or next(reversed(races))
        races.setdefault(name, []).append(row)
    races[rows[0][0]] = list(rows)
    text = table(HEAD, [row for race in RACES for row in races.get(race.name, ())])
    replace_between_markers(document, "speed", f"{_conditions()}\n\n{text}")


def is_of_this_machine(document: Path) -> bool:
    """Whether its table was measured here: rows of two machines are not put into one."""
    return _conditions() in between_markers(document, "speed")


def _conditions() -> str:
    return f"{machine()}, two threads."


def _cells(result: Efficiency) -> Row:
    return (
        str(result.runner.method),
        f"{result.cpu:.2f}",
        f"{result.wall:.2f}",
        f"{result.error.whole:.3g}",
        f"{result.efficiency:.3g}",
    )
