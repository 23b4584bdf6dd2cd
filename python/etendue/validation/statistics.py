"""What independent renders say about a ratio."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, nan, sqrt

import numpy as np

from etendue.arrays import FloatArray
from etendue.extras import extra
from etendue.validation.results import Estimate

#: Of the intervals that are shown.
LEVEL = 0.95
#: Share of a ratio below which nothing is claimed: films hold single precision.
PRECISION = 1e-6


@dataclass(frozen=True, eq=False)
class Samples:
    """The same quantity from n independent renders, (n,), and what it is divided by.

    `reference` is (n,), of other renders, or a number that is known. For a normal distribution the
    n differences measured - r reference have mean 0 if r is the ratio, and Student's t test of
    that is exact (Fieller 1954).
    """

    measured: FloatArray
    reference: FloatArray | float

    @property
    def ratio(self) -> float:
        """NaN where nothing was seen."""
        return float(self.measured.mean() / np.mean(self.reference)) if self._seen else nan

    @property
    def _seen(self) -> bool:
        """Numbers all of them, and something to divide by."""
        numbers = np.isfinite(self.measured).all() and np.isfinite(self.reference).all()
        return bool(numbers and np.mean(self.reference) != 0)

    def p_value(self, ratio: float) -> float:
        """Two-sided, of the hypothesis that the ratio is `ratio`; 0 where nothing was seen: a black
        picture confirms no prediction."""
        if not self._seen:
            return 0.0
        difference = self.measured - ratio * np.asarray(self.reference)
        rounding = PRECISION * abs(ratio * float(np.mean(self.reference)))
        off = max(abs(float(difference.mean())) - rounding, 0.0)
        if off == 0:
            return 1.0
        error = _standard_error(difference)
        if error == 0:
            return 0.0
        return 2 * float(extra("scipy.stats").t.sf(off / error, difference.size - 1))

    def estimate(self, level: float = LEVEL) -> Estimate:
        """The ratio with the interval of all ratios that the test does not refuse at 1 - level.

        Without end where the reference is not resolved from 0.
        """
        if not self._seen:
            return Estimate(nan, -inf, inf, level)
        n = self.measured.size
        t = float(extra("scipy.stats").t.ppf((1 + level) / 2, n - 1))
        reference = np.broadcast_to(np.asarray(self.reference, dtype=np.float64), (n,))
        mean = np.array([self.measured.mean(), reference.mean()])
        (bb, ba), (_, aa) = np.cov(self.measured, reference) * (t * t / n)
        # (mean_b - r mean_a)^2 <= bb - 2 r ba + r^2 aa, solved for r.
        lead = mean[1] ** 2 - aa
        if lead <= 0:
            return Estimate(self.ratio, -inf, inf, level)
        middle = (mean[0] * mean[1] - ba) / lead
        half = sqrt(max(middle**2 - (mean[0] ** 2 - bb) / lead, 0.0))
        rounding = PRECISION * abs(self.ratio)
        low, high = middle - half - rounding, middle + half + rounding
        return Estimate(self.ratio, float(low), float(high), level)


@dataclass(frozen=True, eq=False)
class Blocks:
    """Many ratios that shall all be the same: one for every block of a picture.

    The worst of them speaks for all; its p-value is corrected for the choice (Šidák), which keeps
    it valid, if cautious, where blocks are correlated with each other.
    """

    blocks: tuple[Samples, ...]

    def worst(self, ratio: float) -> Samples:
        return min(self.blocks, key=lambda samples: samples.p_value(ratio))

    def p_value(self, ratio: float) -> float:
        return at_least_one(self.worst(ratio).p_value(ratio), len(self.blocks))


def at_least_one(probability: float, trials: int) -> float:
    """Of an event of that probability, in so many independent trials."""
    return float(-np.expm1(trials * np.log1p(-probability))) if probability < 1 else 1.0


def _standard_error(values: FloatArray) -> float:
    return float(np.std(values, ddof=1)) / sqrt(values.size)
