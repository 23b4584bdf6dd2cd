"""Confidence intervals for people."""

from __future__ import annotations

from math import floor, isfinite, log10
from typing import Protocol


class Interval(Protocol):
    """A value with the ends of its confidence interval; infinite where nothing is known."""

    @property
    def value(self) -> float: ...
    @property
    def low(self) -> float: ...
    @property
    def high(self) -> float: ...


def interval_text(interval: Interval) -> str:
    """'1.78 ± 0.01': the uncertainty to two digits at most, the value to as many places.

    An interval that lies a little to one side, as Fieller's does, shows the longer of its arms.
    """
    arm = max(interval.high - interval.value, interval.value - interval.low)
    if not isfinite(arm):
        return "hidden by noise"
    # A double of a float's precision has no more to tell.
    places = 6 if arm <= 0 else min(6, max(0, 1 - floor(log10(arm))))
    return f"{interval.value:.{places}f} ± {arm:.{places}f}"
