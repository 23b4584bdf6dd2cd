"""The ratio of two sums of noisy pixels, with its confidence interval."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, isfinite, sqrt
from statistics import NormalDist
from typing import Literal

import numpy as np

from etendue.comparison.picture import FloatArray
from etendue.extras import extra

#: Confidence of all intervals, of both sides together.
LEVEL = 0.95

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
    a: FloatArray, b: FloatArray, var_a: FloatArray, var_b: FloatArray
) -> Ratio:
    """Of pixels (n,) with the variances of their means.

    Fieller's interval for the ratio of two independent normal sums. It takes the errors of pixels
    for independent of each other, which splats and filters wider than a pixel are only nearly, and
    holds where no single pixel's noise dominates the sum.
    """
    sum_a, sum_b = float(a.sum()), float(b.sum())
    if sum_a <= 0:
        return Ratio(inf, -inf, inf, a.size, "variance")
    value = sum_b / sum_a
    z = NormalDist().inv_cdf((1 + LEVEL) / 2)
    # The interval of A as a share of A, squared: from 1 on, A may be black.
    g = z * z * float(var_a.sum()) / sum_a**2
    if g >= 1:
        return Ratio(value, -inf, inf, a.size, "variance")
    middle = value / (1 - g)
    spread = sqrt(float(var_b.sum()) * (1 - g) + value * value * float(var_a.sum()))
    half = z * spread / (sum_a * (1 - g))
    return Ratio(value, middle - half, middle + half, a.size, "variance")


def ratio_from_tiles(a: FloatArray, b: FloatArray, pixels: int) -> Ratio:
    """Of the sums (n,) of tiles: the delete-one jackknife with Student's t of n - 1 degrees.

    The scatter of the tiles' own ratios is all that is known of the noise. Where B / A differs
    over the region, that difference counts as noise, and the interval is wider than noise alone
    makes it.
    """
    value = float(b.sum() / a.sum()) if a.sum() > 0 else inf
    rest_a, rest_b = a.sum() - a, b.sum() - b
    if a.size < 2 or rest_a.min() <= 0 or not isfinite(value):
        return Ratio(value, -inf, inf, pixels, "jackknife")
    left_out = rest_b / rest_a
    variance = (a.size - 1) * float(np.mean((left_out - left_out.mean()) ** 2))
    half = float(extra("scipy.stats").t.ppf((1 + LEVEL) / 2, a.size - 1)) * sqrt(variance)
    return Ratio(value, value - half, value + half, pixels, "jackknife")
