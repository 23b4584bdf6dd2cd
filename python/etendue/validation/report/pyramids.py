"""A Pyramid as tables of pictures: a row for each path length, a column for each s."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import ceil

import numpy as np

from etendue.arrays import FloatArray
from etendue.html import common_exposure, picture_url
from etendue.luminance import luminance
from etendue.validation.results import Pyramid, Strategy

#: Pixels. There are many of these pictures, and they are shown small.
WIDTH = 160

#: The images share out the light of one picture. They are shown brighter than it by so much, lest
#: the weak ones be black.
BRIGHTER = 4.0

_Images = Mapping[Strategy, FloatArray]


@dataclass(frozen=True)
class Cell:
    s: int
    t: int
    url: str
    ratio: float | None
    """Mean luminance over that of the right image; None of a right image, and where it is black."""


@dataclass(frozen=True)
class Level:
    title: str
    columns: range
    """The values of s."""
    rows: tuple[tuple[int, tuple[Cell | None, ...]], ...]
    """Path lengths k = s + t - 1 and their cells, one for each column."""


def levels(pyramid: Pyramid) -> list[Level]:
    """All at one exposure, BRIGHTER than that of the picture that the weighted ones add up to."""
    exposure = BRIGHTER * common_exposure(
        _sum(pyramid.weighted_right), _sum(pyramid.weighted_wrong)
    )
    return [
        _level("Weighted, right", pyramid.weighted_right, None, exposure),
        _level("Weighted, wrong", pyramid.weighted_wrong, pyramid.weighted_right, exposure),
        _level("Unweighted, right", pyramid.unweighted_right, None, exposure),
        _level("Unweighted, wrong", pyramid.unweighted_wrong, pyramid.unweighted_right, exposure),
    ]


def _sum(images: _Images) -> FloatArray:
    total: FloatArray = np.sum(list(images.values()), axis=0)
    return total


def _level(title: str, images: _Images, right: _Images | None, exposure: float) -> Level:
    columns = range(max(s for s, _ in images) + 1)
    lengths = sorted({s + t - 1 for s, t in images})
    rows = tuple(
        (k, tuple(_cell((s, k + 1 - s), images, right, exposure) for s in columns)) for k in lengths
    )
    return Level(title, columns, rows)


def _cell(
    strategy: Strategy, images: _Images, right: _Images | None, exposure: float
) -> Cell | None:
    if strategy not in images:
        return None
    image = images[strategy]
    ratio = None if right is None else _ratio(image, right.get(strategy))
    return Cell(*strategy, picture_url(_shrunk(image), exposure), ratio)


def _ratio(wrong: FloatArray, right: FloatArray | None) -> float | None:
    below = 0.0 if right is None else float(luminance(right).mean())
    return float(luminance(wrong).mean()) / below if below > 0 else None


def _shrunk(image: FloatArray) -> FloatArray:
    """Means of square blocks; what is left over at the right and below is cut off."""
    block = ceil(image.shape[1] / WIDTH)
    height, width = image.shape[0] // block, image.shape[1] // block
    blocks = image[: height * block, : width * block].reshape(height, block, width, block, 3)
    means: FloatArray = blocks.mean(axis=(1, 3))
    return means
