"""What the corrections cost."""

from __future__ import annotations

import time

import numpy as np

from etendue.interval import interval_text
from etendue.validation.case import Case, Outcome
from etendue.validation.effort import Effort
from etendue.validation.results import Cost
from etendue.validation.shots import Shot, Studio
from etendue.validation.statistics import Samples

CORRECTIONS = ("refraction", "shading_normal", "phong")
#: CPU time of one render, about.
SECONDS = 0.25

SHOTS = tuple(
    Shot(stage=stage, camera=camera, integrator=integrator, resolution=(160, 120))
    for stage, camera in (
        ("caustic_pool.usda", "/cameras/underwater"),
        ("bump_plane.usda", "/cameras/main"),
        ("phong.usda", "/cameras/main"),
    )
    for integrator in ("light", "bdpt")
)


def _cost(studio: Studio, effort: Effort, shot: Shot) -> Cost:
    """Every pair renders the same paths; which of the two comes first changes with the pair."""
    pairs = effort.pick(8, 24)
    spp = _affordable(studio, shot)
    seconds = np.empty((pairs, 2))
    for pair in range(pairs):
        for which in (0, 1) if pair % 2 == 0 else (1, 0):
            each = shot if which == 0 else shot.without(*CORRECTIONS)
            seconds[pair, which] = _cpu_seconds(studio, each, spp, pair)
    ratio = Samples(seconds[:, 0], seconds[:, 1]).estimate()
    return Cost(shot.stage, shot.integrator, ratio, pairs)


def _cpu_seconds(studio: Studio, shot: Shot, spp: int, take: int = 0) -> float:
    """Of all threads: other programs on the machine change it less than the time that passes."""
    before = time.process_time()
    studio.image(shot, spp, take)
    return time.process_time() - before


def _affordable(studio: Studio, shot: Shot) -> int:
    """Samples that take about as long as a render shall."""
    tried = 4
    return max(tried, round(tried * SECONDS / _cpu_seconds(studio, shot, tried)))


def run(studio: Studio, effort: Effort) -> Outcome:
    costs = tuple(_cost(studio, effort, shot) for shot in SHOTS)
    dearest = max(costs, key=lambda cost: cost.ratio.value)
    return Outcome(
        headline=f"time with over time without the corrections: at most "
        f"{interval_text(dearest.ratio)}, on {dearest.stage} by {dearest.integrator}",
        costs=costs,
    )


CASE = Case(
    name="cost",
    title="What being right costs",
    lesson="""
The corrections are a few multiplications at every scattering of a light path. The table compares
CPU time of renders of the same paths with all three corrections and with none, run in turn.
Paths may end earlier on one side, since Russian roulette looks at what they carry.
""",
    run=run,
)
