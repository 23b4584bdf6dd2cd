"""Errors that a renderer may have, and what measurements would show of them."""

from __future__ import annotations

from dataclasses import dataclass

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


def stuck(factor: str) -> Error:
    return Error(factor, "applied even where it is switched off")


def exchanged(factor: str) -> Error:
    return Error(factor, "applied only where it is switched off")


def seen_by_right(correction: str, wrong_ratio: float) -> dict[Error, float]:
    """What right / truth would be, if leaving the correction out multiplies by `wrong_ratio`.

    Refraction's correction is to leave a factor r alone; inverted, particles are scaled by 1 / r.
    The other two multiply by 1 / r; inverted, by r instead: r^2 too much.
    """
    name = CORRECTIONS[correction]
    turned = 1 / wrong_ratio if correction == "refraction" else wrong_ratio**2
    return {
        dropped(name): wrong_ratio,
        inverted(name): turned,
        stuck(name): 1.0,
        exchanged(name): wrong_ratio,
    }


def seen_by_ratio(correction: str, wrong_ratio: float) -> dict[Error, float]:
    """What wrong / right would be."""
    name = CORRECTIONS[correction]
    right = seen_by_right(correction, wrong_ratio)
    return {
        dropped(name): 1.0,
        inverted(name): wrong_ratio / right[inverted(name)],
        stuck(name): 1.0,
        exchanged(name): 1 / wrong_ratio,
    }


def seen_by_camera(factor: float) -> dict[Error, float]:
    """What light paths / camera paths would be, if camera paths should apply `factor` once."""
    return {dropped(RADIANCE): factor, inverted(RADIANCE): factor**2}
