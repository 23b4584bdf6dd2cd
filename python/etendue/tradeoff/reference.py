"""What errors are measured by."""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from etendue.arrays import FloatArray, Pixels
from etendue.comparison.distance import relative_squared_error, squared_brightness
from etendue.comparison.exr import read_exr
from etendue.comparison.matching import check_lit
from etendue.comparison.picture import Picture
from etendue.exceptions import ComparisonError, SceneError
from etendue.presets import PRESETS
from etendue.settings import RenderOptions
from etendue.tradeoff.rendering import Renderer

#: The integrator that finds all light that any of ours finds, and deeper than anybody looks.
OPTIONS = RenderOptions(integrator="bdpt", max_depth=PRESETS["reference"].max_depth)
#: Parts that a render's variance is from; of whole rounds of passes each part has as many.
_PARTS = 8


@dataclass(frozen=True, eq=False)
class Reference:
    """A picture that counts as right but for its noise."""

    color: FloatArray
    """(h, w, 3), scene-linear"""
    noise: FloatArray | None
    """(h, w): what its noise adds, in the mean, to relative squared errors against it; None when
    the picture does not know.

    The variance is from the scatter of independent parts of the render. To subtract it is the same
    as to multiply the deviations from two different parts, over all pairs of them: unbiased.
    """
    described: str
    seconds: float | None = None

    @property
    def rel_mse(self) -> float | None:
        return None if self.noise is None else float(self.noise.mean())

    @cached_property
    def impartial(self) -> FloatArray:
        """(h, w): makes errors that are relative to a pixel's brightness relative to that of the
        pixels around it.

        Where the reference came out dark by bad luck, its deviation is large, looks small to its
        own variance, and counts much by being divided by little. What is subtracted for the
        reference's noise is right in the mean only under weights that know nothing of that luck.
        """
        grey = self.color.mean(axis=-1)
        mean = float(grey.mean())
        ratio: FloatArray = squared_brightness(grey, mean) / squared_brightness(_around(grey), mean)
        return ratio


def render_reference(renderer: Renderer, view: str, seconds: float, seed: int) -> Reference:
    """Takes about that long, or eight passes if they are longer.

    Raises SceneError, naming the view, for a black picture.
    """
    each = renderer.pass_seconds(OPTIONS, seconds / 20, seed)
    rounds = max(1, round(seconds / (_PARTS * each)))
    passes = _PARTS * rounds
    image = renderer.long_render(OPTIONS, passes, seed)
    if not image.color.any():
        raise SceneError(f"{view} sees no light; there is no error to measure")
    described = f"bdpt, at most {OPTIONS['max_depth']} bounces, {passes:,} samples a pixel"
    return _reference(image.color, image.variance, described, passes * each)


def read_reference(
    file: str | os.PathLike[str], resolution: tuple[int, int] | None
) -> tuple[Reference, tuple[int, int]]:
    """The reference, and its size, which is `resolution` unless that is None.

    Raises FileError for a file that cannot be used, ComparisonError for one of another size, for
    a crop, and for a black one.
    """
    picture = read_exr(file)
    check_lit(picture)
    size = _size(picture)
    if resolution is not None and size != resolution:
        (w, h), (width, height) = size, resolution
        raise ComparisonError(f"{picture.file}: is {w}x{h}, but {width}x{height} was asked for")
    name = Path(picture.file).name
    return _reference(picture.color, picture.variance, f"the file {name}", None), size


def _around(grey: FloatArray) -> FloatArray:
    """Means of the up to eight neighbours of each pixel (h, w); 0 where there is none."""
    height, width = grey.shape
    sums, counts = (
        sum(
            padded[y : y + height, x : x + width]
            for y in range(3)
            for x in range(3)
            if (y, x) != (1, 1)
        )
        for padded in (np.pad(grey, 1), np.pad(np.ones_like(grey), 1))
    )
    around: FloatArray = sums / np.maximum(counts, 1)
    return around


def _size(picture: Picture) -> tuple[int, int]:
    x0, y0, x1, y1 = picture.window
    if (x0, y0) != (0, 0) or not picture.whole:
        raise ComparisonError(
            f"{picture.file}: is a crop of {x1 - x0}x{y1 - y0} at {x0}, {y0}; a reference is whole"
        )
    return x1, y1


def _reference(
    color: Pixels, variance: Pixels | None, described: str, seconds: float | None
) -> Reference:
    right = np.asarray(color, dtype=np.float64)
    noise = None
    if variance is not None and np.isfinite(variance).all():
        noise = relative_squared_error(right + np.sqrt(variance.astype(np.float64)), right)
    return Reference(right, noise, described, seconds)
