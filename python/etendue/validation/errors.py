"""Errors that a renderer may have, and what measurements would show of them."""

from __future__ import annotations

from dataclasses import dataclass
from math import isclose

#: The corrections, in plain words.
CORRECTIONS = {
    "refraction": "the refraction correction of light paths",
    "shading_normal": "the shading-normal factor of light paths",
    "phong": "the adjoint of Phong's classic form",
}
RADIANCE = "the squared index in the radiance of camera paths"


@dataclass(frozen=True)
class Error:
    """Something that a renderer does with a factor, instead of applying it."""

    factor: str
    fault: str

    def __str__(self) -> str:
        return f"{self.factor} is {self.fault}"


def dropped(factor: str) -> Error:
    return Error(factor, "missing")


def inverted(factor: str) -> Error:
    return Error(factor, "inverted")


def seen_by_right(correction: str, wrong_ratio: float) -> dict[Error, float]:
    """What right / truth would be, if leaving the correction out multiplies by `wrong_ratio`.

    Refraction's correction is to leave a factor r alone; inverted, particles are scaled by 1 / r.
    The other two multiply by 1 / r; inverted, by r instead: r^2 too much.
    """
    turned = 1 / wrong_ratio if correction == "refraction" else wrong_ratio**2
    return _distinct(correction, wrong_ratio, turned, 1.0)


def seen_by_ratio(correction: str, wrong_ratio: float) -> dict[Error, float]:
    """What wrong / right would be: the wrong picture stays, the right one is off."""
    right = seen_by_right(correction, wrong_ratio)
    return {error: wrong_ratio / ratio for error, ratio in right.items()}


def seen_by_camera(factor: float) -> dict[Error, float]:
    """What light paths / camera paths would be, if camera paths should apply `factor` once."""
    return {dropped(RADIANCE): factor, inverted(RADIANCE): factor**2}


def _distinct(
    correction: str, dropped_ratio: float, inverted_ratio: float, truth: float
) -> dict[Error, float]:
    """Without the errors that change nothing: they explain nothing."""
    name = CORRECTIONS[correction]
    seen = {dropped(name): dropped_ratio, inverted(name): inverted_ratio}
    return {error: ratio for error, ratio in seen.items() if not isclose(ratio, truth)}
