"""Renders that are made up, of which everything is known: they stand for a renderer's."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import numpy.typing as npt
from pxr import Usd

from etendue.settings import RenderOptions
from etendue.stage import Stage
from etendue.tradeoff import TradeoffResult, candidate_names, tradeoff
from etendue.tradeoff.candidates import CANDIDATES
from etendue.tradeoff.rendering import LongRender, Snapshot
from support.stage_builder import StageBuilder
from support.validation_results import picture

FloatArray = npt.NDArray[np.float64]

#: Independent parts that a render's variance is from.
PARTS = 8


@dataclass(frozen=True)
class Way:
    """How a candidate renders: samples are `found` x truth in the mean, and gamma distributed."""

    noise: float = 0.5
    """Standard deviation of a sample over its mean."""
    pass_seconds: float = 0.01
    missing: float = 0.0
    """Share of the light that it never finds, in the left half of the picture."""


def samples(
    random: np.random.Generator, truth: FloatArray, noise: float, passes: int
) -> FloatArray:
    """The mean of so many passes, (h, w, 3): all channels of a pixel have the same luck."""
    if noise == 0:
        return truth
    shape = passes / noise**2
    luck = random.gamma(shape, 1 / shape, truth.shape[:2])
    return np.asarray(truth * luck[..., None], dtype=np.float64)


def parts(random: np.random.Generator, truth: FloatArray, noise: float, passes: int) -> LongRender:
    """A render with the variance that the scatter of its parts tells."""
    of_parts = np.stack([samples(random, truth, noise, passes // PARTS) for _ in range(PARTS)])
    return LongRender(of_parts.mean(axis=0), of_parts.var(axis=0, ddof=1) / PARTS)


@dataclass
class MadeUp:
    """A Renderer. `interrupt`: in the n-th render of which candidate Ctrl-C comes."""

    ways: Mapping[str, Way]
    truth: FloatArray
    interrupt: tuple[str, int] = ("", 0)
    asked: list[str] = field(default_factory=list)

    def pass_seconds(self, options: RenderOptions, limit: float, seed: int) -> float:
        assert limit > 0
        del seed
        return self._way(options).pass_seconds

    def snapshots(
        self, options: RenderOptions, rungs: Sequence[int], seed: int
    ) -> Sequence[Snapshot]:
        way = self._way(options)
        random = np.random.default_rng(seed)
        found = self.truth * self._found(way)[..., None]
        steps = np.diff([0, *rungs])
        sums = np.cumsum([samples(random, found, way.noise, n) * n for n in steps], axis=0)
        return [
            Snapshot(n, n * way.pass_seconds, total / n)
            for n, total in zip(rungs, sums, strict=True)
        ]

    def long_render(self, options: RenderOptions, passes: int, seed: int) -> LongRender:
        way = self._way(options)
        return parts(np.random.default_rng(seed), self.truth, way.noise, passes)

    def _way(self, options: RenderOptions) -> Way:
        name = next((c.name for c in CANDIDATES if c.options == options), "reference")
        self.asked.append(name)
        # The first time it is asked for the trial.
        if (name, self.asked.count(name) - 1) == self.interrupt:
            raise KeyboardInterrupt
        return self.ways.get(name, Way())

    def _found(self, way: Way) -> FloatArray:
        """(h, w): share of the light."""
        found: FloatArray = np.ones_like(self.truth[..., 0])
        found[:, : found.shape[1] // 2] -= way.missing
        return found


WAYS = {
    "path": Way(noise=20.0, pass_seconds=0.004),
    "light": Way(noise=0.3),
    "bdpt-depth-4": Way(pass_seconds=0.005, missing=0.2),
    "bdpt-no-light-image": Way(noise=400.0),
}


def made_up_stage() -> Usd.Stage:
    return StageBuilder().lit_quad().stage


def made_up_result(
    ways: Mapping[str, Way] = WAYS,
    only: Sequence[str] | None = None,
    reference: Path | None = None,
    interrupt: tuple[str, int] = ("", 0),
) -> TradeoffResult:
    """Of tradeoff(), with renders of 24 x 32 pixels."""

    def renderer(stage: Stage, camera: str | None, resolution: tuple[int, int]) -> MadeUp:
        assert stage.cameras == (camera,)
        assert resolution == (32, 24)
        return MadeUp(ways, picture(), interrupt)

    return tradeoff(
        made_up_stage(),
        resolution=None if reference else (32, 24),
        time=30.0,
        only=candidate_names() if only is None else only,
        reference=reference,
        renderer=renderer,
    )
