"""Factors that a renderer may have forgotten, and what they would make of the picture."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from math import isfinite

from etendue.comparison.ratio import Ratio
from etendue.exceptions import SettingsError

NAMES = {1.333: "water", 1.5: "glass", 2.42: "diamond"}
#: Indices of refraction that are thought of when nobody says which are in the scene.
INDICES = tuple(NAMES)
#: Of η, and what it would be.
POWERS = {2: "one uncancelled η²", -2: "one uncancelled η⁻²", 4: "two uncancelled η², η⁴"}
#: Half the interval over the ratio: from here on so much of all numbers fits that a fit means
#: nothing. (The nine factors of three indices, each ± 5 %, take a sixth of 0.17 ... 34.)
NARROW = 0.05


@dataclass(frozen=True)
class Cause:
    """Radiance scaled at refraction where it should not be, or the reverse (theory.md §5)."""

    eta: float
    power: int

    @property
    def factor(self) -> float:
        """That it gives the ratio."""
        return self.eta**self.power

    def __str__(self) -> str:
        name = f", {NAMES[self.eta]}" if self.eta in NAMES else ""
        return f"{POWERS[self.power]} = {self.factor:.4g} (η = {self.eta:g}{name})"


def fitting_causes(ratio: Ratio, indices: Iterable[float] = INDICES) -> tuple[Cause, ...]:
    """Those whose factor is within the interval; none where no cause is needed."""
    if not ratio.known or 1 in ratio:
        return ()
    return tuple(cause for cause in _causes(indices) if cause.factor in ratio)


def likely_cause(ratio: Ratio, indices: Iterable[float] = INDICES) -> Cause | None:
    """The one that fits, when only one does and the ratio is known well enough for that to mean
    something. A match is no proof: other errors may make the same number."""
    fitting = fitting_causes(ratio, indices)
    narrow = ratio.high - ratio.low <= 2 * NARROW * abs(ratio.value)
    return fitting[0] if len(fitting) == 1 and narrow else None


def check_indices(indices: Iterable[float]) -> tuple[float, ...]:
    """Raises SettingsError for what cannot be an index of refraction that changes brightness."""
    checked = tuple(dict.fromkeys(float(index) for index in indices))
    for index in checked:
        if not isfinite(index) or index <= 0 or index == 1:
            raise SettingsError(f"index of refraction {index:g}: must be over 0 and not 1")
    return checked


def _causes(indices: Iterable[float]) -> Iterator[Cause]:
    return (Cause(index, power) for index in indices for power in POWERS)
