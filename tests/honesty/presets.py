"""What the presets take and give."""

from __future__ import annotations

import sys
from collections.abc import Iterator

import numpy as np

from etendue.presets import PRESETS
from etendue.settings import RenderOptions
from honesty.cases import BAR
from honesty.claims import claims, open_stage, percent, reference
from support.marked_table import Row

DIAL_HEAD = ("preset", "error", "max depth", "spp at most")
HEAD = (
    "stage",
    "preset",
    "spp",
    "CPU s / megapixel",
    "claimed",
    "actual",
    "reference's error",
    "actual / claimed relMSE",
)
RESOLUTION = (24, 18)
#: The longest preset's renders are long enough to do with one.
SEEDS = {"draft": 8, "preview": 8, "final": 4, "reference": 1}


def dial() -> Iterator[Row]:
    """What they set."""
    for name, preset in PRESETS.items():
        yield [name, percent(preset.error), str(preset.max_depth), str(preset.spp)]


def rows(stages: list[str]) -> Iterator[Row]:
    """Of default renders, against one as deep as the deepest, with half the relMSE of the best, or
    with twice its samples where that does not suffice."""
    best = PRESETS["reference"]
    for name in stages:
        stage = open_stage(name)
        options = RenderOptions(resolution=RESOLUTION)
        longest: RenderOptions = {
            **options,
            "max_depth": best.max_depth,
            "error": 0.7 * best.error,
            "spp": 2 * best.spp,
        }
        against = reference(stage, longest)
        for preset, seeds in SEEDS.items():
            found = claims(stage, against, {**options, "preset": preset}, range(seeds))
            megapixels = RESOLUTION[0] * RESOLUTION[1] / 1e6
            ratio = found.actual.mean() / found.claimed.mean()
            cells = [
                name,
                preset,
                f"{found.spp.mean():.0f}",
                f"{found.cpu.mean() / megapixels:.3g}",
                percent(np.sqrt(found.claimed.mean())),
                percent(np.sqrt(max(0.0, found.actual.mean()))),
                percent(against.error),
                f"{ratio:.2f}" if BAR[0] <= ratio <= BAR[1] else f"{ratio:.2f} (missed)",
            ]
            print(" | ".join(cells), file=sys.stderr, flush=True)
            yield cells
