"""etendue.tradeoff()."""

from __future__ import annotations

import math
import os
import time as clock
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from hashlib import blake2b

from etendue.exceptions import SettingsError, TradeoffInterrupted
from etendue.extras import extra
from etendue.progress import StepProgress
from etendue.stage import Stage, open_stage
from etendue.tradeoff.candidates import Candidate, chosen_candidates
from etendue.tradeoff.fit import FALSE_ALARM
from etendue.tradeoff.front import choices, front
from etendue.tradeoff.measurement import Measured, Measuring
from etendue.tradeoff.reference import Reference, read_reference, render_reference
from etendue.tradeoff.rendering import Renderer, StageRenderer
from etendue.tradeoff.results import ReferenceResult, TradeoffResult
from etendue.usd_reader import StageLike
from etendue.validation.environment import environment
from etendue.validation.statistics import LEVEL, at_least_one

#: Seconds of all renders together.
TIME = 180.0
#: Pixels across and down, at most.
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
    resolution: default: the reference's if that is a file, else the view's own, or as much smaller
        as makes it at most 160 wide and high.
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
    candidates that have been rendered twice at least.
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
    """Of the same aspect, and never larger than the view."""
    scale = min(1.0, WIDTH / max(full))
    width, height = (max(1, round(scale * pixels)) for pixels in full)
    return width, height


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
    measurings: list[Measuring] = field(default_factory=list)

    def all(self, reference: Reference | None, progress: StepProgress | None) -> TradeoffResult:
        """In rounds of one render of each candidate: a machine that is slower for a while is so for
        all of them alike, and Ctrl-C leaves the rounds before."""
        names = ["trials", *(f"round {number + 1}" for number in range(SEEDS))]
        if reference is None:
            names.insert(0, "reference")
        steps = iter(enumerate(names))

        def next_step() -> None:
            done, name = next(steps)
            if progress:
                progress(name, done, len(names))

        left = self.time
        if reference is None:
            next_step()
            seed = self._seed("reference", 0)
            view = f"{self.stage.source}: {self.camera}"
            reference = render_reference(self.renderer, view, _REFERENCE_PART * self.time, seed)
            left -= _REFERENCE_PART * self.time
        try:
            next_step()
            self._try_all(reference, left / (len(self.chosen) * (SEEDS + 0.5)))
            for number in range(SEEDS):
                next_step()
                for measuring in self.measurings:
                    measuring.take(self._seed(measuring.candidate.name, number + 1))
        except KeyboardInterrupt:
            if not self._finished:
                raise
            raise TradeoffInterrupted(self._result(reference)) from None
        return self._result(reference)

    def _try_all(self, reference: Reference, seconds: float) -> None:
        """`seconds` of each render to come; a trial takes half of that."""
        for candidate in self.chosen:
            seed = self._seed(candidate.name, 0)
            self.measurings.append(Measuring(candidate, self.renderer, reference, seconds, seed))

    @property
    def _finished(self) -> list[Measuring]:
        """Those of which anything can be said."""
        return [measuring for measuring in self.measurings if measuring.takes > 1]

    def _seed(self, name: str, take: int) -> int:
        key = f"{self.seed} {name} {take}".encode()
        return int.from_bytes(blake2b(key, digest_size=7).digest(), "little")

    def _result(self, reference: Reference) -> TradeoffResult:
        finished = self._finished
        measured = [measuring.measured() for measuring in finished]
        best = _best(measured)
        candidates = tuple(one.relative_to(best) for one in measured)
        names = {one.name for one in candidates}
        return TradeoffResult(
            stage=self.stage.source,
            camera=self.camera,
            resolution=self.resolution,
            full_resolution=self.full_resolution,
            seeds=min(measuring.takes for measuring in finished),
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
            not_run=tuple(one.name for one in self.chosen if one.name not in names),
            interrupted=any(measuring.takes < SEEDS for measuring in self.measurings),
        )


def _best(measured: list[Measured]) -> Measured:
    """The most efficient without a floor, if there is one: others' errors stop falling.

    Of those whose error is seen, if there is one: a ratio to what is not seen says nothing.
    """
    honest = [one for one in measured if one.result.verdict != "floor"] or measured
    seen = [one for one in honest if one.costs.mean() > 0] or honest
    return min(seen, key=lambda one: float(one.costs.mean()))
