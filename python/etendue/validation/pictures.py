"""Pictures for the report, and blocks of pictures for the checks."""

from __future__ import annotations

import numpy as np

from etendue.arrays import FloatArray
from etendue.luminance import luminance, quotient
from etendue.validation.results import PicturePair
from etendue.validation.shots import Shot, Studio
from etendue.validation.statistics import Blocks, Samples


def picture_pair(
    studio: Studio,
    shot: Shot,
    correction: str,
    spp: int,
    title: str,
    caption: str,
    *,
    full_scale: float = 2.0,
    predicted_ratio: FloatArray | None = None,
) -> PicturePair:
    """The shot with and without a correction, from the same random numbers."""
    right = np.asarray(studio.image(shot, spp).color, dtype=np.float64)
    wrong = np.asarray(studio.image(shot.without(correction), spp).color, dtype=np.float64)
    return PicturePair(
        title, caption, right, wrong, ratio_map(right, wrong), full_scale, predicted_ratio
    )


def ratio_map(right: FloatArray, wrong: FloatArray) -> FloatArray:
    """(h, w): luminance of wrong over right; NaN where right is black."""
    return quotient(luminance(wrong), luminance(right))


def blocks_of(
    measured: FloatArray, reference: FloatArray, rows: int, columns: int, floor: float = 0.02
) -> Blocks:
    """Of takes (n, h, w) each: the ratio in rows x columns blocks of the picture.

    Blocks darker than `floor` times the mean say nothing and are left out. Of a picture that is
    black, or holds what is no number, all blocks stay, and confirm nothing.
    """
    top, bottom = _block_means(measured, rows, columns), _block_means(reference, rows, columns)
    dark = bottom.mean(axis=0) < floor * bottom.mean()
    return Blocks(tuple(Samples(top[:, i], bottom[:, i]) for i in np.flatnonzero(~dark)))


def _block_means(takes: FloatArray, rows: int, columns: int) -> FloatArray:
    """(n, h, w) to (n, rows * columns); rows divide h and columns w."""
    n, height, width = takes.shape
    cut = takes.reshape(n, rows, height // rows, columns, width // columns)
    means: FloatArray = cut.mean(axis=(2, 4)).reshape(n, -1)
    return means
