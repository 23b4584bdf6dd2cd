"""What it gains to place samples where the noise is."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator

import numpy as np

import etendue
from etendue.comparison.distance import relative_squared_error
from etendue.settings import RenderOptions
from honesty.claims import FloatArray, open_stage
from support.marked_table import Row

HEAD = (
    "stage",
    "integrator",
    "relMSE, even",
    "adaptive",
    "even / adaptive",
    "CPU s, adaptive / even",
    "gain",
)
RESOLUTION = (256, 192)
SPP = 64
#: Two are known by their difference; noise is averaged over 49 152 pixels.
SEEDS = (0, 1)
STAGES = (
    "bump_plane",
    "bump_sphere",
    "caustic_pool",
    "cornell_box",
    "cornell_indirect",
    "flat_pool",
    "furnace",
    "glass_sphere",
    "phong",
    "sundial",
)
INTEGRATORS = ("path", "bdpt")


def rel_mse(pair: list[FloatArray], truth: FloatArray) -> float:
    """Of either of two independent pictures, from their difference."""
    a, b = pair
    return float(relative_squared_error(truth + (a - b), truth).mean()) / 2


def pictures(
    stage: etendue.Stage, options: RenderOptions
) -> tuple[dict[bool, list[FloatArray]], dict[bool, float]]:
    """Of each seed, even and adaptive in turn; with user CPU seconds."""
    colors: dict[bool, list[FloatArray]] = {False: [], True: []}
    cpu = {False: 0.0, True: 0.0}
    for seed in SEEDS:
        for adaptive in colors:
            ours: RenderOptions = {**options, "seed": seed, "adaptive": adaptive}
            before = os.times().user
            image = stage.render(**ours)
            cpu[adaptive] += os.times().user - before
            colors[adaptive].append(image.color.astype(np.float64))
    return colors, cpu


def rows(stages: list[str]) -> Iterator[Row]:
    for name in stages:
        stage = open_stage(name)
        for integrator in INTEGRATORS:
            options = RenderOptions(
                resolution=RESOLUTION, spp=SPP, integrator=integrator, threads=2
            )
            colors, cpu = pictures(stage, options)
            truth: FloatArray = np.mean([*colors[False], *colors[True]], axis=0)
            even, adaptive = (rel_mse(colors[kind], truth) for kind in (False, True))
            cost = cpu[True] / cpu[False]
            cells = [
                name,
                integrator,
                f"{even:.3g}",
                f"{adaptive:.3g}",
                f"{even / adaptive:.2f}",
                f"{cost:.2f}",
                f"**{even / adaptive / cost:.2f}**",
            ]
            print(" | ".join(cells), f"{cpu[False]:.1f} CPU s", file=sys.stderr, flush=True)
            yield cells
