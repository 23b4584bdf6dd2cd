"""The ratio of two sums of noisy pixels, with its confidence interval."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, isfinite, sqrt
from typing import Literal

import numpy as np

from etendue.arrays import FloatArray
from etendue.extras import extra

#: Confidence of all intervals, of both sides together.
LEVEL = 0.95
#: A pixel's variance is an estimate itself; ours is from eight parts of the render.
FREEDOM = 7

Method = Literal["variance", "jackknife"]


@dataclass(frozen=True)
class Ratio:
    """Luminance of B over that of A, both summed over a region."""

    value: float
    low: float
    high: float
    pixels: int
    method: Method
    """variance: Fieller's interval from the files' variance channels; jackknife: over tiles."""
    level: float = LEVEL

    def __contains__(self, value: float) -> bool:
        return self.low <= value <= self.high

    @property
    def known(self) -> bool:
        """False where noise hides the ratio: the interval has no end."""
        return isfinite(self.low) and isfinite(self.high)


def ratio_from_variances(
    a: FloatArray, b: FloatArray, var_a: FloatArray, var_b: FloatArray, correlation: float = 1.0
) -> Ratio:
    """Of pixels (n,) with the variances of their means, and what noise_correlation() found.

    Fieller's interval for the ratio of two independent normal sums, with Student's t of as many
    degrees of freedom as the pixels that matter have together (Welch and Satterthwaite): where a
    few noisy pixels make the sum, they also make the estimate of its variance.
    """
    sum_a, sum_b = float(a.sum()), float(b.sum())
    if sum_a <= 0:
        return Ratio(inf, -inf, inf, a.size, "variance")
    value = sum_b / sum_a
    t = _quantile(_freedom(value * value * var_a, var_b) / correlation)
    of_a, of_b = correlation * float(var_a.sum()), correlation * float(var_b.sum())
    # The interval of A as a share of A, squared: from 1 on, A may be black.
    g = t * t * of_a / sum_a**2
    if g >= 1:
        return Ratio(value, -inf, inf, a.size, "variance")
    middle = value / (1 - g)
    half = t * sqrt(of_b * (1 - g) + value * value * of_a) / (sum_a * (1 - g))
    return Ratio(value, middle - half, middle + half, a.size, "variance")


def ratio_from_tiles(a: FloatArray, b: FloatArray, pixels: int) -> Ratio:
    """Of the sums (n,) of tiles: the delete-one jackknife with Student's t.

    The scatter of the tiles' own ratios is all that is known of the noise. Where B / A differs
    over the region, that difference counts as noise, and the interval is wider than noise alone
    makes it. Tiles of which the region has little count little as degrees of freedom.
    """
    total = float(a.sum())
    value = float(b.sum()) / total if total > 0 else inf
    rest_a, rest_b = a.sum() - a, b.sum() - b
    freedom = total**2 / float((a**2).sum()) - 1 if total > 0 else 0.0
    if freedom < 1 or rest_a.min() <= 0:
        return Ratio(value, -inf, inf, pixels, "jackknife")
    left_out = rest_b / rest_a
    variance = (a.size - 1) * float(np.mean((left_out - left_out.mean()) ** 2))
    half = _quantile(freedom) * sqrt(variance)
    return Ratio(value, value - half, value + half, pixels, "jackknife")


def _freedom(*variances: FloatArray) -> float:
    """Degrees of freedom of the sum of all."""
    squares = sum(float((variance**2).sum()) for variance in variances)
    total = sum(float(variance.sum()) for variance in variances)
    return FREEDOM * total**2 / squares if squares > 0 else inf


def _quantile(freedom: float) -> float:
    """Of Student's t."""
    return float(extra("scipy.stats").t.ppf((1 + LEVEL) / 2, freedom))
