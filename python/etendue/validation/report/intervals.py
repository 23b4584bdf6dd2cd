"""Measured intervals beside their predictions, as marks on a line that a case's checks share."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import floor, isfinite, log10

import numpy as np

from etendue.validation.results import Check

#: A check far off its prediction must not squeeze the others' intervals into dots.
_WIDEST = 5.0


@dataclass(frozen=True)
class Mark:
    """Places on the line, 0..1; the prediction is at 0.5."""

    low: float
    value: float
    high: float
    beyond: str
    """Beyond which end the value lies, "left" or "right"; else empty."""


@dataclass(frozen=True)
class Marks:
    scale: float
    """measured / predicted - 1 at the line's right end"""
    of: dict[str, Mark]
    """By the checks' names, where there is something to show."""


def marks(checks: Sequence[Check]) -> Marks:
    """Of a case."""
    shown = [check for check in checks if _is_shown(check)]
    if not shown:
        return Marks(1.0, {})
    scale = _scale([_deviations(check) for check in shown])
    return Marks(scale, {check.name: _mark(_deviations(check), scale) for check in shown})


def _is_shown(check: Check) -> bool:
    measured = check.measured
    numbers = (check.predicted, measured.low, measured.value, measured.high)
    return all(isfinite(number) for number in numbers) and check.predicted != 0


def _deviations(check: Check) -> tuple[float, float, float]:
    """Of low, value and high from the prediction, as shares of it."""
    measured = check.measured
    low, value, high = (
        number / check.predicted - 1 for number in (measured.low, measured.value, measured.high)
    )
    return low, value, high


def _scale(deviations: list[tuple[float, float, float]]) -> float:
    arms = [(high - low) / 2 for low, _, high in deviations]
    farthest = max(max(abs(low), abs(high)) for low, _, high in deviations)
    typical = float(np.median(arms))
    return _rounded_up(min(farthest, max(_WIDEST * typical, *arms)))


def _rounded_up(scale: float) -> float:
    """To 1, 2 or 5 times a power of ten; exact measurements still need a line."""
    power = 10.0 ** floor(log10(max(scale, 1e-6)))
    return power * next(step for step in (1, 2, 5, 10) if step * power >= scale)


def _mark(deviations: tuple[float, float, float], scale: float) -> Mark:
    low, value, high = (
        min(1.0, max(0.0, 0.5 + 0.5 * deviation / scale)) for deviation in deviations
    )
    beyond = "" if abs(deviations[1]) <= scale else ("right" if deviations[1] > 0 else "left")
    return Mark(low, value, high, beyond)
