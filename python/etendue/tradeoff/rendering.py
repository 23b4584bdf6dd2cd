"""Renders that stop on the way to be looked at, and how long they took."""

from __future__ import annotations

import os
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Protocol

from etendue._core import RenderProgress
from etendue.arrays import Pixels
from etendue.session import Session
from etendue.settings import RenderOptions
from etendue.stage import Stage


@dataclass(frozen=True, eq=False)
class Snapshot:
    """What a render had made of the picture after so many passes."""

    passes: int
    seconds: float
    """CPU time of the render alone, over the cores."""
    color: Pixels
    """(h, w, 3), scene-linear"""


@dataclass(frozen=True, eq=False)
class LongRender:
    """A picture that knows its noise."""

    color: Pixels
    """(h, w, 3), scene-linear"""
    variance: Pixels
    """(h, w, 3), of the pixels' means"""


class Renderer(Protocol):
    """Makes the pictures. Tests put in their own."""

    def pass_seconds(self, options: RenderOptions, limit: float, seed: int) -> float:
        """What a pass takes, from a trial of so many seconds, or of one pass if that is longer."""

    def snapshots(
        self, options: RenderOptions, rungs: Sequence[int], seed: int
    ) -> Sequence[Snapshot]:
        """Of one render, after each of `rungs` passes, which rise."""

    def long_render(self, options: RenderOptions, passes: int, seed: int) -> LongRender:
        """One that is not looked at on the way."""


@dataclass(frozen=True)
class StageRenderer:
    """One view of one stage. Raises what Stage.render() raises."""

    stage: Stage
    camera: str | None
    resolution: tuple[int, int]

    def pass_seconds(self, options: RenderOptions, limit: float, seed: int) -> float:
        watch = _Watch([1])
        watch.run(self._session(options, seed, watch, {"spp": 0, "time": limit}))
        if not watch.passes:
            # Not one pass in that time.
            return self.snapshots(options, [1], seed)[0].seconds
        return watch.seconds / watch.passes

    def snapshots(
        self, options: RenderOptions, rungs: Sequence[int], seed: int
    ) -> Sequence[Snapshot]:
        watch = _Watch(rungs)
        watch.run(self._session(options, seed, watch, {"spp": rungs[-1]}))
        return watch.taken

    def long_render(self, options: RenderOptions, passes: int, seed: int) -> LongRender:
        image = self._session(options, seed, None, {"spp": passes, "aovs": ("variance",)}).run()
        return LongRender(image.color, image["variance"])

    def _session(
        self, options: RenderOptions, seed: int, watch: _Watch | None, more: RenderOptions
    ) -> Session:
        ours: RenderOptions = {**options, **more, "resolution": self.resolution, "seed": seed}
        return self.stage.session(self.camera, progress=watch, **ours)


@dataclass
class _Watch:
    """Takes the snapshots, from the render's own thread: between passes nobody adds to the film.

    Time is the CPU's, of all threads, over the cores: what else runs on the machine would count
    for the candidate that is being measured just then. Taking snapshots does not count.
    """

    rungs: Sequence[int]
    taken: list[Snapshot] = field(default_factory=list)
    passes: int = 0
    seconds: float = 0.0
    _begin: float = 0.0
    _session: Session | None = None

    def run(self, session: Session) -> None:
        self._session = session
        self._begin = time.process_time()
        try:
            session.run()
        finally:
            # The session holds us, where no garbage collector sees it: it would stay for ever.
            self._session = None

    def __call__(self, progress: RenderProgress) -> None:
        if progress.finished or self._session is None:
            return
        now = time.process_time()
        self.passes = progress.passes_done
        self.seconds = (now - self._begin) / _cores()
        if self.passes in self.rungs:
            color = self._session.snapshot().color
            self.taken.append(Snapshot(self.passes, self.seconds, color))
            self._begin += time.process_time() - now


def _cores() -> int:
    return len(os.sched_getaffinity(0))
