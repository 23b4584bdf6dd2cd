"""One candidate, measured."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from math import inf, nan

import numpy as np

from etendue.arrays import FloatArray, Pixels
from etendue.comparison.distance import relative_squared_error
from etendue.comparison.tiles import tile_numbers, tile_sums
from etendue.luminance import luminance, quotient
from etendue.tradeoff.candidates import Candidate
from etendue.tradeoff.fit import Floor, curve, floor, positive_mean, shared_error, slope
from etendue.tradeoff.reference import Reference
from etendue.tradeoff.rendering import Renderer, Snapshot
from etendue.tradeoff.results import FIREFLIES, HIDING, CandidateResult, Rung, Verdict
from etendue.validation.results import Estimate
from etendue.validation.statistics import LEVEL, Samples

#: Part of the pixels that `outliers` looks at.
_FEW = 1e-3
#: Squared relative error of a pixel that is the rounding of 32-bit floats, and no error.
_ROUNDING = 1e-12
#: Passes of the longest renders at least: fewer make no line.
_LEAST = 4
#: Shortest renders: so many halvings of the longest.
_HALVINGS = 7


def ladder(longest: int) -> tuple[int, ...]:
    """Passes to stop after: the longest, and its halves."""
    return tuple(sorted({max(1, longest >> halvings) for halvings in range(_HALVINGS + 1)}))


class Measuring:
    """A candidate in the course of being measured, one render after another."""

    def __init__(
        self,
        candidate: Candidate,
        renderer: Renderer,
        reference: Reference,
        seconds: float,
        seed: int,
    ) -> None:
        """Makes a trial, which tells how many passes take `seconds`: half as long, if a pass is."""
        self.candidate = candidate
        self._renderer = renderer
        self._reference = reference
        each = renderer.pass_seconds(candidate.options, seconds / 2, seed)
        self._rungs = ladder(max(_LEAST, round(seconds / each)))
        self._seen = _Seen(reference)

    def take(self, seed: int) -> None:
        """Renders once more."""
        options = self.candidate.options
        self._seen.add(self._renderer.snapshots(options, self._rungs, seed))

    @property
    def takes(self) -> int:
        return len(self._seen.errors)

    def measured(self) -> Measured:
        """Of two takes at least."""
        return _measured(self.candidate, self._seen, self._reference)


@dataclass(frozen=True, eq=False)
class Measured:
    """All that is known of a candidate by itself."""

    result: CandidateResult
    """Without `relative_efficiency`."""
    costs: FloatArray
    """(n,): relMSE x seconds of the longest renders."""

    def relative_to(self, best: Measured) -> CandidateResult:
        """Efficiency over that of the best, from the rounds that both have: what slowed the machine
        down in one of them slowed both. NaN where either's error is not seen."""
        if not (best.costs.mean() > 0 and self.costs.mean() > 0):
            return self.result
        rounds = min(best.costs.size, self.costs.size)
        found = Samples(best.costs[:rounds], self.costs[:rounds]).estimate()
        return replace(self.result, relative_efficiency=replace(found, low=max(found.low, 0.0)))


def measured(
    candidate: Candidate, takes: Iterable[Sequence[Snapshot]], reference: Reference
) -> Measured:
    """Of independent renders, at least two, of the same passes each."""
    seen = _Seen(reference)
    for take in takes:
        seen.add(take)
    return _measured(candidate, seen, reference)


def _measured(candidate: Candidate, seen: _Seen, reference: Reference) -> Measured:
    errors, times = np.array(seen.errors), np.array(seen.times)
    of_mean = seen.of_mean
    shared = shared_error(of_mean, seen.of_each, len(errors), seen.noise)
    found = floor(shared * reference.impartial)
    if reference.noise is None:
        found = replace(found, p_value=nan)
    costs = errors[:, -1] * times[:, -1]
    cost = positive_mean(costs)
    outliers = _outliers(seen.of_each)
    result = CandidateResult(
        candidate=candidate,
        rungs=_rungs(seen.passes, errors, times),
        pooled=_pooled(seen.passes[-1], errors, times, float((of_mean - seen.noise).mean())),
        slope=slope(errors, times),
        floor=found.estimate,
        floor_p_value=found.p_value,
        verdict=_verdict(found, outliers),
        curve=curve(errors, times, found),
        efficiency=_inverse(cost),
        relative_efficiency=Estimate(nan, -inf, inf, LEVEL),
        brightness=Samples(np.array(seen.means), luminance(reference.color).mean()).estimate(),
        outliers=outliers,
        picture=seen.first,
        ratio=_tiled_ratio(luminance(seen.mean), luminance(reference.color)),
    )
    return Measured(result, costs)


class _Seen:
    """Sums over the renders: pictures are looked at one after another."""

    def __init__(self, reference: Reference) -> None:
        self.reference = reference
        self.noise: FloatArray = (
            np.zeros(reference.color.shape[:2]) if reference.noise is None else reference.noise
        )
        self.errors: list[list[float]] = []
        self.times: list[list[float]] = []
        self.means: list[float] = []
        self.passes: tuple[int, ...] = ()
        self.of_each: FloatArray = np.zeros_like(self.noise)
        self._sum: FloatArray = np.zeros_like(reference.color)

    def add(self, take: Sequence[Snapshot]) -> None:
        off = [self._off(snapshot.color) for snapshot in take]
        last = np.asarray(take[-1].color, dtype=np.float64)
        if not self.errors:
            self.first = last
            self.passes = tuple(snapshot.passes for snapshot in take)
        self.errors.append([float((error - self.noise).mean()) for error in off])
        self.times.append([snapshot.seconds for snapshot in take])
        self.means.append(float(luminance(last).mean()))
        self.of_each += off[-1]
        self._sum += last

    @property
    def mean(self) -> FloatArray:
        """(h, w, 3)"""
        return self._sum / len(self.errors)

    @property
    def of_mean(self) -> FloatArray:
        return self._off(self.mean)

    def _off(self, picture: Pixels) -> FloatArray:
        error = relative_squared_error(picture, self.reference.color)
        return np.where(error > _ROUNDING, error, 0.0)


def _rungs(passes: Sequence[int], errors: FloatArray, times: FloatArray) -> tuple[Rung, ...]:
    return tuple(
        Rung(count, float(times[:, rung].mean()), positive_mean(errors[:, rung]))
        for rung, count in enumerate(passes)
    )


def _pooled(passes: int, errors: FloatArray, times: FloatArray, of_mean: float) -> Rung:
    """The mean picture of all n renders. Of its like there is only one, and no interval."""
    error = Estimate(of_mean, -inf, inf, LEVEL)
    return Rung(len(errors) * passes, float(times[:, -1].sum()), error)


def _verdict(found: Floor, outliers: float) -> Verdict:
    if found.resolved:
        return "floor"
    arm = found.estimate.high - found.estimate.value
    hidden = np.isnan(found.p_value) or arm > HIDING or outliers > FIREFLIES
    return "unknown" if hidden else "converges"


def _inverse(positive: Estimate) -> Estimate:
    if not positive.value > 0:
        return Estimate(nan, -inf, inf, positive.level)
    low = 1 / positive.high if positive.high > 0 else 0.0
    high = 1 / positive.low if positive.low > 0 else inf
    return Estimate(1 / positive.value, low, high, positive.level)


def _tiled_ratio(measured: FloatArray, right: FloatArray) -> FloatArray:
    """(h, w), of the tiles that pixels lie in: of single pixels, noise would hide what is off."""
    tiles = tile_numbers(*right.shape)
    return quotient(tile_sums(measured, tiles)[tiles], tile_sums(right, tiles)[tiles])


def _outliers(squared: FloatArray) -> float:
    """Share of (h, w) that lies in the few largest."""
    total = float(squared.sum())
    few = max(1, round(_FEW * squared.size))
    return float(np.sort(squared, axis=None)[-few:].sum()) / total if total > 0 else 0.0
