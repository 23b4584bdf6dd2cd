"""What errors measured at several times say: slope, floor, curve."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, inf, nan, sqrt

import numpy as np

from etendue.arrays import FloatArray
from etendue.comparison.tiles import tile_numbers, tile_sums
from etendue.extras import extra
from etendue.validation.results import Estimate
from etendue.validation.statistics import LEVEL

#: A candidate without a floor is said to have one this often.
FALSE_ALARM = 1e-3


@dataclass(frozen=True)
class Curve:
    """relMSE(t) = a / t + b."""

    noise: Estimate
    """a, in seconds: what time removes."""
    floor: float
    """b, never negative; 0 unless it is resolved."""

    def at(self, seconds: float) -> float:
        return self.noise.value / seconds + self.floor


@dataclass(frozen=True)
class Floor:
    """b of relMSE(t) = a / t + b: the squared error that all renders have in common."""

    estimate: Estimate
    p_value: float
    """One-sided, of the hypothesis that there is none; NaN where it cannot be told."""

    @property
    def resolved(self) -> bool:
        return self.p_value < FALSE_ALARM


def positive_mean(values: FloatArray) -> Estimate:
    """Of (n,) that are positive in the mean: Student's interval of its logarithm."""
    mean = float(values.mean())
    if values.size < 2 or not mean > 0:
        return Estimate(mean, -inf, inf, LEVEL)
    arm = _quantile(values.size - 1) * float(values.std(ddof=1)) / sqrt(values.size) / mean
    # Few values with one far out: the interval has no end that a number holds.
    return Estimate(mean, mean * exp(-min(arm, 50.0)), mean * exp(min(arm, 50.0)), LEVEL)


def slope(errors: FloatArray, times: FloatArray) -> Estimate:
    """Of (n, rungs) each: of the straight line through log mean error over log mean time.

    The interval is from leaving out each of the n renders in turn (jackknife).
    """
    n = len(errors)
    value = _log_slope(errors.mean(axis=0), times.mean(axis=0))
    if errors.shape[1] < 2 or n < 2:
        return Estimate(value, -inf, inf, LEVEL)
    kept = [np.arange(n) != left_out for left_out in range(n)]
    others = np.array([_log_slope(errors[k].mean(axis=0), times[k].mean(axis=0)) for k in kept])
    error = sqrt((n - 1) * float(np.mean((others - others.mean()) ** 2)))
    arm = _quantile(n - 1) * error
    if not np.isfinite(arm):
        return Estimate(value, -inf, inf, LEVEL)
    return Estimate(value, value - arm, value + arm, LEVEL)


def shared_error(
    of_mean: FloatArray, of_each: FloatArray, count: int, reference_noise: FloatArray
) -> FloatArray:
    """(h, w): relative squared error that independent renders have in common, without bias.

    The product of two renders' deviations from the reference, over all pairs of `count` renders: it
    has no noise of the renders in its mean, whatever their noise is like. From the squared errors
    of their mean picture, `of_mean`, and those of each, summed up, `of_each`; that the reference
    deviates from the truth is in all pairs, and subtracted.
    """
    pairs = (count**2 * of_mean - of_each) / (count * (count - 1))
    error: FloatArray = pairs - reference_noise
    return error


def floor(shared: FloatArray) -> Floor:
    """Of what shared_error() gives, under weights that do not know the reference's noise.

    Student's t test over tiles of the picture, in each of which it is 0 in the mean where there is
    no floor. Rare bright spots make single tiles stand out, and the scatter of tiles with them: a
    floor must be seen in many places to be called one. The interval counts differences of the
    floor over the picture as noise, too.
    """
    tiles = tile_numbers(*shared.shape)
    sums = tile_sums(shared, tiles)
    value = float(shared.mean())
    if sums.size < 2:
        return Floor(Estimate(value, -inf, inf, LEVEL), nan)
    error = float(sums.std(ddof=1)) * sqrt(sums.size) / shared.size
    arm = _quantile(sums.size - 1) * error
    if error == 0:
        return Floor(Estimate(value, value, value, LEVEL), 0.0 if value > 0 else 1.0)
    p_value = float(extra("scipy.stats").t.sf(value / error, sums.size - 1))
    return Floor(Estimate(value, value - arm, value + arm, LEVEL), p_value)


def curve(errors: FloatArray, times: FloatArray, found: Floor) -> Curve:
    """Of (n, rungs) each.

    b is the floor's, if it is resolved: what renders have in common says more of it than the bend
    of a curve. a is the mean of (relMSE - b) t, rungs weighted by their time: where the slope is
    not quite -1, the end of the curve is what is gone on from. Weights by the errors themselves
    would prefer rungs that happened to miss rare bright samples.
    """
    b = max(found.estimate.value, 0.0) if found.resolved else 0.0
    t = times.mean(axis=0)
    return Curve(positive_mean(((errors - b) * t * t).sum(axis=1) / t.sum()), b)


def _log_slope(errors: FloatArray, times: FloatArray) -> float:
    """NaN where an error, freed of the reference's noise, is not positive."""
    if len(errors) < 2 or errors.min() <= 0:
        return nan
    x, y = np.log(times) - np.log(times).mean(), np.log(errors)
    return float((x * y).sum() / (x * x).sum())


def _quantile(freedom: int) -> float:
    """Of Student's t, both sides."""
    return float(extra("scipy.stats").t.ppf((1 + LEVEL) / 2, freedom))
