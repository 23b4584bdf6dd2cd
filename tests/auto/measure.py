"""What methods cost, and what auto chooses."""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

import etendue
from auto.cases import FIXED, SECONDS, View, candidate_of
from etendue.comparison.distance import squared_brightness
from etendue.settings import RenderOptions
from etendue.tradeoff.candidates import Candidate
from etendue.tradeoff.rendering import StageRenderer
from honesty.claims import open_stage

FloatArray = npt.NDArray[np.float64]

RESOLUTION = (48, 36)
#: Of a render, in CPU seconds over cores.
RENDER_SECONDS = 0.4
#: Of the pixels, those that are left out of relMSE, as the pilot does (core/src/session/pilot.cpp).
LEFT_OUT = 0.01
#: Their pictures together are what the others' are held against.
POOLED = tuple(candidate.name for candidate in FIXED if "-paths-" in candidate.name)
#: A picture that is darker than the others' by more lacks light.
LACKING = 0.02


@dataclass(frozen=True)
class Costs:
    """relMSE x CPU seconds of one candidate, an entry for each seed."""

    of_seed: FloatArray
    complete: bool
    """Its picture is as bright as the others'."""

    @property
    def mean(self) -> float:
        return float(self.of_seed.mean())


@dataclass(frozen=True)
class Choice:
    candidate: str
    pilot_seconds: float
    """CPU time."""

    @property
    def overhead(self) -> float:
        """Cost of a render with its pilot over that of one without."""
        return 1 + self.pilot_seconds / SECONDS


@dataclass(frozen=True)
class _Render:
    color: FloatArray
    variance: FloatArray
    """(h, w), of the mean; a mean over channels"""
    seconds: float


def costs(view: View, seeds: Iterable[int]) -> dict[str, Costs]:
    """By candidate. They take turns: what else the machine does slows all of them alike."""
    stage = open_stage(view.stage)
    renderer = StageRenderer(stage, view.camera, RESOLUTION)
    passes = {
        candidate.name: _whole_rounds(RENDER_SECONDS, renderer, candidate) for candidate in FIXED
    }
    renders: dict[str, list[_Render]] = {candidate.name: [] for candidate in FIXED}
    for seed in seeds:
        for candidate in FIXED:
            found = _render(stage, view, candidate, passes[candidate.name], seed)
            renders[candidate.name].append(found)
    right = _Pooled([one for name in POOLED for one in renders[name]])
    return {name: _costs(found, right, name in POOLED) for name, found in renders.items()}


def choices(view: View, seeds: Iterable[int]) -> list[Choice]:
    """What auto chooses for long renders, which are cancelled once it has."""
    stage = open_stage(view.stage)
    return [_choice(stage, view, seed) for seed in seeds]


def _whole_rounds(seconds: float, renderer: StageRenderer, candidate: Candidate) -> int:
    """Passes, sixteen at least: variance is told by eight replicates of two."""
    each = renderer.pass_seconds(candidate.options, seconds / 8, 0)
    return 8 * max(2, round(seconds / each / 8))


def _render(
    stage: etendue.Stage, view: View, candidate: Candidate, passes: int, seed: int
) -> _Render:
    options: RenderOptions = {
        **candidate.options,
        "resolution": RESOLUTION,
        "spp": passes,
        "seed": seed,
        "aovs": ("variance",),
    }
    before = time.process_time()
    image = stage.render(view.camera, **options)
    seconds = time.process_time() - before
    variance = image["variance"].astype(np.float64).mean(axis=-1)
    return _Render(image.color.astype(np.float64), variance, seconds)


class _Pooled:
    """What all renders of bdpt with all its strategies show."""

    def __init__(self, renders: list[_Render]) -> None:
        """Weights them by how little noise they have."""
        weights = np.array([1 / max(float(one.variance.mean()), 1e-300) for one in renders])
        weights /= weights.sum()
        self.color: FloatArray = np.tensordot(weights, [one.color for one in renders], 1)
        self.noise: FloatArray = np.tensordot(weights**2, [one.variance for one in renders], 1)
        grey = self.color.mean(axis=-1)
        self.bright = squared_brightness(grey, float(grey.mean()))

    def noise_of(self, render: _Render) -> float:
        """relMSE that it sees itself."""
        return _trimmed_mean(render.variance / self.bright)

    def error_of(self, render: _Render) -> float:
        """relMSE by its distance from here, of a render that is no part of it."""
        off = ((render.color - self.color) ** 2).mean(axis=-1) - self.noise
        return _trimmed_mean(off / self.bright)


def _costs(renders: list[_Render], right: _Pooled, is_part: bool) -> Costs:
    """Where a render has not met the light that makes its noise, it still lacks it."""
    of_seed = [
        one.seconds * max(right.noise_of(one), 0 if is_part else right.error_of(one))
        for one in renders
    ]
    brightness = np.mean([one.color.mean() for one in renders]) / right.color.mean()
    return Costs(np.array(of_seed), bool(brightness > 1 - LACKING))


def _trimmed_mean(terms: FloatArray) -> float:
    kept = int(np.ceil((1 - LEFT_OUT) * terms.size))
    return float(np.sort(terms, axis=None)[:kept].mean())


def _choice(stage: etendue.Stage, view: View, seed: int) -> Choice:
    session = stage.session(
        view.camera, integrator="auto", resolution=(160, 120), time=10 * SECONDS, seed=seed
    )
    before = time.process_time()
    with session:
        while (chosen := session.snapshot().statistics.chosen) is None:
            time.sleep(0.01)
        seconds = time.process_time() - before
    return Choice(candidate_of(chosen), seconds)
