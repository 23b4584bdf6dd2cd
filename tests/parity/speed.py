"""Efficiency of renderers on the same picture, taken in turn.

Efficiency is 1 / (relMSE x CPU seconds): what a second buys, whatever the number of samples.
"""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass

import numpy as np

from parity.plain_scene import Floats
from parity.processes import RendererProcess
from parity.races import RACES, Race, Runner
from parity.report import Results, Row, table
from parity.tasks import Picture

ROUNDS = 5
#: Pixels darker than this part of the mean count as if they had it.
DARKEST = 0.02
#: Part of the pixels, the worst, that the robust error leaves out.
TRIMMED = 0.001


@dataclass(frozen=True)
class Efficiency:
    """Of one runner."""

    runner: Runner
    cpu: float  #: seconds per render
    wall: float  #: seconds per render
    error: float  #: relMSE
    robust_error: float  #: the same without the worst pixels

    @property
    def efficiency(self) -> float:
        """Per CPU second."""
        return 1 / (self.error * self.cpu)

    @property
    def robust_efficiency(self) -> float:
        """Per CPU second."""
        return 1 / (self.robust_error * self.cpu)


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
    """Long enough for its own noise not to count."""
    with RendererProcess(race.case.task(race.reference.method, race.width)) as process:
        return process.render(_samples(race.reference.spp, effort), 1).image


def _efficiency(runner: Runner, pictures: list[Picture], reference: Floats) -> Efficiency:
    errors = [_relative_errors(picture.image, reference) for picture in pictures]
    kept = round((1 - TRIMMED) * reference[..., 0].size)
    return Efficiency(
        runner=runner,
        cpu=float(np.mean([picture.cpu for picture in pictures])),
        wall=float(np.mean([picture.wall for picture in pictures])),
        error=float(np.mean(errors)),
        robust_error=float(np.mean([error[:kept].mean() for error in errors])),
    )


def _relative_errors(image: Floats, reference: Floats) -> Floats:
    """Per pixel, squared, the smallest first."""
    squared = ((image - reference) ** 2).mean(axis=2)
    scale = reference.mean(axis=2) ** 2 + (DARKEST * reference.mean()) ** 2
    return np.sort((squared / scale).ravel())


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


def results_table(results: Results) -> str:
    """Of all races that were ever run."""
    return table(HEAD, [line for race in RACES for line in results.get(race.name) or ()])


def _cells(result: Efficiency) -> Row:
    return (
        str(result.runner.method),
        f"{result.cpu:.2f}",
        f"{result.wall:.2f}",
        f"{result.error:.3g}",
        f"{result.efficiency:.3g}",
    )
