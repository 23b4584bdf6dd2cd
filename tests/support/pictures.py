"""Statistics of independent renders of one picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy import stats

import etendue
from etendue.settings import RenderOptions

FloatArray = npt.NDArray[np.float64]

#: Chance that a right renderer fails one comparison.
FALSE_ALARM = 1e-5


def replicas(
    stage: etendue.Stage, count: int, first_seed: int, options: RenderOptions
) -> FloatArray:
    """Luminances (count, h, w) of renders with seeds of their own, without invalid samples."""
    images = []
    for seed in range(first_seed, first_seed + count):
        seeded: RenderOptions = {**options, "seed": seed}
        image = stage.render(**seeded)
        assert sum(image.statistics.invalid.values()) == 0
        images.append(image.color.astype(np.float64) @ [0.2126, 0.7152, 0.0722])
    return np.array(images)


@dataclass(frozen=True)
class Comparison:
    """Outcome of Welch t-tests of every pixel, every 4 x 4 block, and the mean."""

    p: float  #: the smallest p-value, Bonferroni-corrected
    where: str
    resolution: float  #: standard error of the difference of the means, relative

    def __str__(self) -> str:
        return f"p = {self.p:.3g} at {self.where}; mean resolved to {self.resolution:.2%}"


def compare(a: FloatArray, b: FloatArray) -> Comparison:
    """Tests whether two sets of replicas show the same picture."""
    smallest = (1.0, "nowhere")
    scales = {"pixel": 1, "block": 4, "image": max(a.shape[1:])}
    for name, size in scales.items():
        cells_a, cells_b = _blocks(a, size), _blocks(b, size)
        p = stats.ttest_ind_from_stats(
            *_moments(cells_a), *_moments(cells_b), equal_var=False
        ).pvalue
        worst = np.unravel_index(np.argmin(p), p.shape)
        corrected = min(1.0, float(p[worst]) * p.size * len(scales))
        if corrected < smallest[0]:
            ratio = cells_a.mean(0)[worst] / cells_b.mean(0)[worst]
            smallest = (corrected, f"{name} {tuple(map(int, worst))}, ratio {ratio:.4f}")
    means_a, means_b = a.mean((1, 2)), b.mean((1, 2))
    error = np.hypot(stats.sem(means_a), stats.sem(means_b)) / means_b.mean()
    return Comparison(*smallest, float(error))


def _moments(cells: FloatArray) -> tuple[FloatArray, FloatArray, int]:
    mean = cells.mean(0)
    # A strategy that carries 1e-5 of a pixel may not have occurred in it once, and so be missing
    # from mean and scatter alike (a dome's own image, splat by splat). Scatter below 1e-4 is not
    # believed; the means are resolved to some 1e-3 at best.
    unseen = 1e-4 * np.abs(mean) + np.finfo(np.float32).tiny
    return mean, np.maximum(cells.std(0, ddof=1), unseen), len(cells)


def _blocks(images: FloatArray, size: int) -> FloatArray:
    count, height, width = images.shape
    rows = [images[:, y : y + size] for y in range(0, height, size)]
    cells = [[row[:, :, x : x + size].mean((1, 2)) for x in range(0, width, size)] for row in rows]
    return np.array(cells).transpose(2, 0, 1).reshape(count, len(rows), -1)
