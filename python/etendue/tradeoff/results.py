"""What etendue.tradeoff() finds, for programs and for the report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite, log, nan
from typing import Literal

from etendue.arrays import FloatArray
from etendue.tradeoff.candidates import Candidate
from etendue.tradeoff.fit import Curve
from etendue.validation.results import Estimate

#: `outliers` from which on a few pixels say how large the error is; of plain noise it is some 0.03.
FIREFLIES = 0.25

#: relMSE of a floor, 30 % of error, that makes a picture a wrong one by any measure.
HIDING = 0.1

Verdict = Literal["converges", "floor", "unknown"]


@dataclass(frozen=True)
class Rung:
    """Renders that were stopped after so many passes."""

    passes: int
    seconds: float
    """Of one of them: CPU time of the render alone, over the cores."""
    rel_mse: Estimate
    """Mean over seeds, free of the reference's noise."""


@dataclass(frozen=True, eq=False)
class CandidateResult:
    """One way to render, measured. Arrays have row 0 on top."""

    candidate: Candidate
    rungs: tuple[Rung, ...]
    """Shortest first."""
    pooled: Rung
    """The mean picture of all seeds: as good as one render of all their passes."""
    slope: Estimate
    """Of log relMSE over log time; -1 where all error is noise of independent samples."""
    floor: Estimate
    """relMSE that no time removes, b of relMSE(t) = a / t + b. May be negative, by noise."""
    floor_p_value: float
    """How probable a floor this high is where there is none; NaN where it cannot be told."""
    verdict: Verdict
    """unknown: the reference's own noise is not known, the picture has too few parts, noise would
    hide a floor as high as HIDING, or there are fireflies: more of them may have been missed."""
    curve: Curve
    efficiency: Estimate
    """1 / (relMSE x seconds), of the longest renders."""
    relative_efficiency: Estimate
    """Over that of the best candidate without a floor whose error is seen; NaN, as `efficiency`,
    where its own is not: with the reference's noise taken away, nothing is left."""
    brightness: Estimate
    """Mean luminance over the reference's."""
    outliers: float
    """Share of the longest renders' squared error that lies in a thousandth of the pixels."""
    picture: FloatArray
    """(h, w, 3), scene-linear: the longest render of one seed."""
    ratio: FloatArray
    """(h, w): luminance of the mean picture over the reference's, tile by tile; NaN where that is
    black."""

    @property
    def name(self) -> str:
        return self.candidate.name

    @property
    def fireflies(self) -> bool:
        """Its figures rest on a few pixels: six renders do not tell much of them."""
        return self.outliers > FIREFLIES

    @property
    def hidden_floor(self) -> float:
        """relMSE that would not have been seen in the noise; no floor is negative."""
        return max(self.floor.high, self.floor.high - self.floor.value)

    @property
    def error_seen(self) -> bool:
        """Of the longest renders; where it is not, nothing tells them from exact ones."""
        return self.rungs[-1].rel_mse.value > 0

    @property
    def end_slope(self) -> float:
        """From one of the longest renders to the mean of all, which is worth as many times as long;
        NaN where an error, freed of the reference's noise, is not positive."""
        last, pooled = self.rungs[-1], self.pooled
        if not (last.rel_mse.value > 0 and pooled.rel_mse.value > 0):
            return nan
        longer = pooled.seconds / last.seconds
        return log(pooled.rel_mse.value / last.rel_mse.value) / log(longer)

    @property
    def pass_seconds(self) -> float:
        """Of one pass."""
        last = self.rungs[-1]
        return last.seconds / last.passes


@dataclass(frozen=True, eq=False)
class ReferenceResult:
    """What everything is measured by."""

    described: str
    rel_mse: float | None
    """Of its own noise, which the errors are freed of; None when it is not known."""
    picture: FloatArray
    """(h, w, 3), scene-linear"""
    seconds: float | None
    """None for a file."""


@dataclass(frozen=True)
class Choice:
    """What to render with when there is so much time."""

    seconds: float
    best: str
    """Name of the candidate with the least expected error."""
    rel_mse: Estimate
    """Expected of it."""
    as_good: tuple[str, ...]
    """Others that the measurement does not tell from it."""
    extrapolated: bool
    """The time is longer than all renders of it together, whose mean picture is as good as one
    render so long: the curve says what comes then, nothing measured."""


@dataclass(frozen=True)
class Span:
    """Of time, in which one candidate gives the least error."""

    best: str
    """Its name."""
    begin: float
    """Seconds."""
    end: float


@dataclass(frozen=True, eq=False)
class TradeoffResult:
    """What etendue.tradeoff() returns."""

    stage: str
    camera: str
    resolution: tuple[int, int]
    full_resolution: tuple[int, int]
    """That a render of the stage has by default: its times are longer by the pixels."""
    seeds: int
    """Independent renders behind every interval, at least."""
    seed: int
    level: float
    """Confidence of the intervals, each by itself."""
    false_alarm_rate: float
    """How often any candidate at all is said to have a floor although none has."""
    reference: ReferenceResult
    candidates: tuple[CandidateResult, ...]
    choices: tuple[Choice, ...]
    """By time."""
    front: tuple[Span, ...]
    """By time."""
    environment: Mapping[str, str]
    seconds: float
    not_run: tuple[str, ...] = ()
    """Candidates that were asked for, and rendered less than twice before Ctrl-C."""
    interrupted: bool = False

    def __getitem__(self, name: str) -> CandidateResult:
        """KeyError when it was not measured."""
        for found in self.candidates:
            if found.name == name:
                return found
        raise KeyError(name)


def is_known(estimate: Estimate) -> bool:
    """Its interval has ends."""
    return isfinite(estimate.low) and isfinite(estimate.high)
