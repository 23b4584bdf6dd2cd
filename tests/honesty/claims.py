"""What renders claim to be off by, and what they are off by."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

import etendue
from etendue.comparison.distance import relative_squared_error
from etendue.settings import RenderOptions

STAGES = Path(__file__).resolve().parents[2] / "stages"

FloatArray = npt.NDArray[np.float64]

#: Seeds below it are those of the renders that are judged.
REFERENCE_SEED = 1_000_000


@dataclass(frozen=True)
class Reference:
    """A long render, with what is known of its own noise."""

    color: FloatArray  #: (h, w, 3)
    rel_mse: float  #: what its noise adds, in the mean, to the relMSE of any picture against it
    mean_error: float  #: standard error of its mean over its mean; all channels have the same luck

    @property
    def error(self) -> float:
        return float(np.sqrt(self.rel_mse))

    def off(self, image: etendue.Image) -> float:
        """relMSE of an independent picture, free of the reference's noise; may be negative."""
        return float(relative_squared_error(image.color, self.color).mean()) - self.rel_mse


@dataclass(frozen=True)
class Claims:
    """Of renders that differ in their seeds, an entry for each."""

    claimed: FloatArray  #: relMSE
    actual: FloatArray  #: relMSE
    brightness: FloatArray  #: mean of the picture over the reference's
    spp: FloatArray
    cpu: FloatArray  #: seconds, the setting-up of the scene included

    def brightness_error(self, against: Reference) -> float:
        """Standard error of the mean brightness: of the seeds, and of the reference, which all of
        them have in common."""
        of_seeds = self.brightness.std(ddof=1) / np.sqrt(self.brightness.size)
        return float(np.hypot(of_seeds, self.brightness.mean() * against.mean_error))

    @property
    def ratios(self) -> FloatArray:
        """Actual over claimed relMSE."""
        return self.actual / self.claimed


def percent(relative: float) -> str:
    return f"{100 * relative:.3g}%"


def open_stage(name: str) -> etendue.Stage:
    return etendue.open(STAGES / f"{name}.usda")


def reference(stage: etendue.Stage, options: RenderOptions) -> Reference:
    """The seed and the AOVs are ours, the rest is the caller's."""
    ours: RenderOptions = {**options, "seed": REFERENCE_SEED, "aovs": ["variance"]}
    image = stage.render(**ours)
    color = image.color.astype(np.float64)
    noise = np.sqrt(image["variance"].astype(np.float64))
    of_pixels = noise.mean(axis=-1)
    return Reference(
        color,
        float(relative_squared_error(color + noise, color).mean()),
        float(np.sqrt((of_pixels**2).sum()) / of_pixels.size / color.mean()),
    )


def claims(
    stage: etendue.Stage, against: Reference, options: RenderOptions, seeds: range
) -> Claims:
    """Renders with each of the seeds; `options` must let them know their error."""
    rows = []
    for seed in seeds:
        seeded: RenderOptions = {**options, "seed": seed}
        before = time.process_time()
        image = stage.render(**seeded)
        cpu = time.process_time() - before
        rows.append(
            (
                image.statistics.error**2,
                against.off(image),
                image.color.mean(dtype=np.float64) / against.color.mean(),
                image.statistics.passes,
                cpu,
            )
        )
    return Claims(*np.array(rows, dtype=np.float64).T)
