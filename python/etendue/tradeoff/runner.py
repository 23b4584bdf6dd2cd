"""etendue.tradeoff()."""

from __future__ import annotations

import math
import os
import time as clock
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from hashlib import blake2b

from etendue.exceptions import SettingsError, TradeoffInterrupted
from etendue.extras import extra
from etendue.progress import StepProgress
from etendue.stage import Stage, open_stage
from etendue.tradeoff.candidates import Candidate, chosen_candidates
from etendue.tradeoff.fit import FALSE_ALARM
from etendue.tradeoff.front import choices, front
from etendue.tradeoff.measurement import Measured, measure
from etendue.tradeoff.reference import Reference, read_reference, render_reference
from etendue.tradeoff.rendering import Renderer, StageRenderer
from etendue.tradeoff.results import ReferenceResult, TradeoffResult
from etendue.usd_reader import StageLike
from etendue.validation.environment import environment
from etendue.validation.statistics import LEVEL, at_least_one

#: Seconds of all renders together.
TIME = 180.0
#: Pixels across.
WIDTH = 160
#: Independent renders of every candidate.
SEEDS = 6
#: Part of the time that the reference gets: its noise is to be well below all others'.
_REFERENCE_PART = 1 / 3

MakeRenderer = Callable[[Stage, str | None, tuple[int, int]], Renderer]


def tradeoff(
    stage: Stage | StageLike,
    *,
    camera: str | None = None,
    resolution: tuple[int, int] | None = None,
    time: float = TIME,
    seed: int = 1,
    only: Iterable[str] | None = None,
    reference: str | os.PathLike[str] | None = None,
    progress: StepProgress | None = None,
    renderer: MakeRenderer = StageRenderer,
) -> TradeoffResult:
    """Measures what errors ways to render the stage reach in what time.

    stage: a file, a Usd.Stage, or what etendue.open() returned.
    resolution: default: the reference's if that is a file, else 160 wide.
    time: seconds of all renders together, on a machine that does nothing else.
    only: names of candidate_names(); default all.
    reference: an EXR file to measure by, whole, linear Rec.709; default: a third of the time goes
        into a render. A file's noise is known when it has a variance, as ours do that were rendered
        with that AOV.
    renderer: makes what renders; another one may be tried in place of ours.

    The same seed gives the same pictures, but how many passes fit into the time depends on the
    machine. Raises what etendue.open() and Stage.render() raise, SettingsError for a name that is
    not known or a time that is no time, FileError and ComparisonError for a reference, Error when
    the extra `report` is not installed, and on Ctrl-C TradeoffInterrupted, which carries the
    candidates that have finished.
    """
    if not (time > 0 and math.isfinite(time)):
        raise SettingsError(f"time is {time}; it must be a positive number of seconds")
    chosen = chosen_candidates(only)
    extra("scipy.stats")  # missed before the work
    opened = stage if isinstance(stage, Stage) else open_stage(stage)
    camera, full = opened.view(camera)
    opened.view(camera, resolution)  # refused before the work
    against = None
    if reference is not None:
        against, resolution = read_reference(reference, resolution)
    size = resolution or _small(full)
    run = _Run(opened, camera, size, full, time, seed, chosen, renderer(opened, camera, size))
    return run.all(against, progress)


def _small(full: tuple[int, int]) -> tuple[int, int]:
    width, height = full
    return WIDTH, max(1, round(WIDTH * height / width))


@dataclass
class _Run:
    stage: Stage
    camera: str
    resolution: tuple[int, int]
    full_resolution: tuple[int, int]
    time: float
    seed: int
    chosen: tuple[Candidate, ...]
    renderer: Renderer
    started: float = field(default_factory=clock.perf_counter)
    finished: list[Measured] = field(default_factory=list)

    def all(self, reference: Reference | None, progress: StepProgress | None) -> TradeoffResult:
        left = self.time
        # A file is there already.
        steps = len(self.chosen) + (reference is None)
        if reference is None:
            if progress:
                progress("reference", 0, steps)
            left -= _REFERENCE_PART * self.time
            reference = render_reference(
                self.renderer, _REFERENCE_PART * self.time, self._seed("reference", 0)
            )
        # A trial, of half as long as the others, comes first.
        seconds = left / (len(self.chosen) * (SEEDS + 0.5))
        try:
            for candidate in self.chosen:
                if progress:
                    done = steps - len(self.chosen) + len(self.finished)
                    progress(candidate.name, done, steps)
                seeds = [self._seed(candidate.name, take) for take in range(SEEDS + 1)]
                self.finished.append(measure(candidate, self.renderer, reference, seconds, seeds))
        except KeyboardInterrupt:
            if not self.finished:
                raise
            not_run = tuple(left.name for left in self.chosen[len(self.finished) :])
            found = replace(self._result(reference), not_run=not_run)
            raise TradeoffInterrupted(found) from None
        return self._result(reference)

    def _seed(self, name: str, take: int) -> int:
        key = f"{self.seed} {name} {take}".encode()
        return int.from_bytes(blake2b(key, digest_size=7).digest(), "little")

    def _result(self, reference: Reference) -> TradeoffResult:
        best = _best(self.finished)
        candidates = tuple(one.relative_to(best) for one in self.finished)
        return TradeoffResult(
            stage=self.stage.source,
            camera=self.camera,
            resolution=self.resolution,
            full_resolution=self.full_resolution,
            seeds=SEEDS,
            seed=self.seed,
            level=LEVEL,
            false_alarm_rate=at_least_one(FALSE_ALARM, len(candidates)),
            reference=ReferenceResult(
                reference.described, reference.rel_mse, reference.color, reference.seconds
            ),
            candidates=candidates,
            choices=choices(candidates),
            front=front(candidates),
            environment=environment(),
            seconds=clock.perf_counter() - self.started,
        )


def _best(finished: list[Measured]) -> Measured:
    """The most efficient without a floor, if there is one: others' errors stop falling."""
    honest = [one for one in finished if one.result.verdict != "floor"] or finished
    return min(honest, key=lambda one: float(one.costs.mean()))
