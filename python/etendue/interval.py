"""Confidence intervals for people."""

from __future__ import annotations

from math import floor, isfinite, log10
from typing import Protocol

#: Longer over shorter arm from which an interval is told by its ends.
LOPSIDED = 1.25


class Interval(Protocol):
    """A value with the ends of its confidence interval; infinite where nothing is known."""

    @property
    def value(self) -> float: ...
    @property
    def low(self) -> float: ...
    @property
    def high(self) -> float: ...


def interval_text(interval: Interval) -> str:
    """'1.78 ± 0.01', or '2.3 (1.2 to 4.8)' where the value is not in the middle.

    The uncertainty has two digits at most, the value as many places.
    """
    value, low, high = interval.value, interval.low, interval.high
    arm = max(value - low, high - value)
    if not isfinite(arm):
        return "hidden by noise"
    if arm <= 1e-6 * abs(value):
        # A double of a float's precision has no more to tell.
        return f"{value:.6g}"
    if max(abs(value), arm) >= 1e6 or arm < 1e-6:
        return f"{value:.4g} ± {arm:.2g}"
    places = max(0, 1 - floor(log10(arm)))
    if arm > LOPSIDED * min(value - low, high - value):
        return f"{value:.{places}f} ({low:.{places}f} to {high:.{places}f})"
    return f"{value:.{places}f} ± {arm:.{places}f}"
