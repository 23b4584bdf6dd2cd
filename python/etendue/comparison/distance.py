"""How far one picture is from another."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from etendue import _core
from etendue.arrays import FloatArray, Pixels
from etendue.extras import extra

#: Pixels that FLIP is measured on without being asked: it takes some 6 s a million.
FLIP_PIXELS = 2**22
#: Rows whose errors are in memory at a time.
_BAND = 64


@dataclass(frozen=True)
class Distance:
    """Of a picture from another one that counts as right."""

    rel_mse: float
    """Mean of relative_squared_error."""
    flip: float | None
    """Mean HDR-FLIP, 0..1; None when it was not measured."""


def distance(image: Pixels, reference: Pixels, flip: bool | None = None) -> Distance:
    """Of (h, w, 3), with FLIP or without it; None: up to FLIP_PIXELS."""
    if flip is None:
        flip = reference[..., 0].size <= FLIP_PIXELS
    return Distance(
        mean_relative_squared_error(image, reference),
        flip_error(image, reference) if flip else None,
    )


def mean_relative_squared_error(image: Pixels, reference: Pixels) -> float:
    """Of (h, w, 3), some rows at a time."""
    mean = float(reference.mean(dtype=np.float64))
    bands = range(0, len(reference), _BAND)
    errors = (
        relative_squared_error(image[y : y + _BAND], reference[y : y + _BAND], mean).sum()
        for y in bands
    )
    return float(sum(errors)) / reference[..., 0].size


def relative_squared_error(
    images: Pixels, reference: Pixels, mean: float | None = None
) -> FloatArray:
    """Per pixel (..., h, w), of (..., h, w, 3) against (h, w, 3); its mean is called relMSE.

    (e_r^2 + e_g^2 + e_b^2) / 3 over m^2 + (0.02 M)^2, where m is the mean of the reference's
    channels there and M its mean everywhere, or `mean`. 0.02 is DARKEST_PART: black would divide
    by zero.
    RenderStatistics.error is what a render expects the root of that mean to be.
    """
    right = reference.astype(np.float64)
    squared = ((images - right) ** 2).mean(axis=-1)
    relative: FloatArray = squared / squared_brightness(
        right.mean(axis=-1), float(right.mean()) if mean is None else mean
    )
    return relative


def squared_brightness(grey: FloatArray, mean: float) -> FloatArray:
    """What squared errors are relative to, of a reference's means over channels and over all."""
    squared: FloatArray = grey**2 + (_core.DARKEST_PART * mean) ** 2
    return squared


def flip_error(image: Pixels, reference: Pixels) -> float:
    """Mean HDR-FLIP, 0..1 (Andersson et al. 2021), at 67 pixels per degree.

    The exposures are the reference's. Negative values, which a filter may leave, count as black.
    """
    shown = [np.maximum(picture, 0).astype(np.float32) for picture in (reference, image)]
    _, mean, _ = extra("flip_evaluator").evaluate(*shown, "HDR", applyMagma=False)
    return float(mean)
