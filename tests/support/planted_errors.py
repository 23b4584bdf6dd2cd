"""Renderers with an error, for the validation suite to find."""

from __future__ import annotations

import functools
from dataclasses import replace

import numpy as np

from etendue.arrays import FloatArray
from etendue.image import FloatArray as Pixels
from etendue.image import Image
from etendue.validation import validate
from etendue.validation.results import ValidationResult
from etendue.validation.shots import Renderer, Shot, render

#: What the suite's samples are divided by: its tests are about errors that are gross.
FEWER = 8


class Repainted(Image):
    """An image with other colours; all else stays, its strategies' images too."""

    def __init__(self, image: Image, color: FloatArray) -> None:
        super().__init__(image._rendered, image.metadata)
        self._color = color.astype(np.float32)

    def __getitem__(self, aov: str) -> Pixels:
        return self._color if aov == "color" else super().__getitem__(aov)


def honest(shot: Shot, spp: int, seed: int) -> Image:
    """Ours, with fewer samples."""
    return render(shot, max(1, spp // FEWER), seed)


@functools.cache
def honest_run(case: str) -> ValidationResult:
    """The suite's result for one case, once for all tests."""
    return validate([case], renderer=honest)


def dropping(correction: str) -> Renderer:
    """Never applies it."""
    return lambda shot, spp, seed: honest(_off(shot, correction), spp, seed)


def exchanging(correction: str) -> Renderer:
    """Applies it when it is turned off, and else does not."""

    def rendered(shot: Shot, spp: int, seed: int) -> Image:
        if correction in shot.off:
            return ignoring(correction)(shot, spp, seed)
        return dropping(correction)(shot, spp, seed)

    return rendered


def ignoring(correction: str) -> Renderer:
    """Always applies it: nothing happens when it is turned off."""

    def rendered(shot: Shot, spp: int, seed: int) -> Image:
        off = tuple(name for name in shot.off if name != correction)
        return honest(replace(shot, off=off), spp, seed)

    return rendered


def inverting(correction: str) -> Renderer:
    """Applies the inverse. Turned off, the correction's factor f is missing, wrong = right / f; its
    inverse makes right / f^2. What refraction's does is to leave r alone: wrong = r right; its
    inverse makes right / r."""

    def painted(right: FloatArray, wrong: FloatArray) -> FloatArray:
        top, bottom = (right, wrong) if correction == "refraction" else (wrong, right)
        return np.divide(top * top, bottom, out=np.zeros_like(top), where=bottom > 0)

    def rendered(shot: Shot, spp: int, seed: int) -> Image:
        image = honest(shot, spp, seed)
        if correction in shot.off or shot.integrator == "path":
            return image
        # The same paths, pixel by pixel.
        wrong = honest(_off(shot, correction), spp, seed)
        return Repainted(image, painted(_color(image), _color(wrong)))

    return rendered


def _off(shot: Shot, correction: str) -> Shot:
    return replace(shot, off=tuple({*shot.off, correction}))


def _color(image: Image) -> FloatArray:
    return np.asarray(image.color, dtype=np.float64)
