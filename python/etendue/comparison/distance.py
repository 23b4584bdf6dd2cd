"""How far one picture is from another."""

from __future__ import annotations

import numpy as np

from etendue.comparison.picture import FloatArray
from etendue.extras import extra

#: A pixel darker than this part of the mean counts about as that bright: black divides by zero.
DARKEST = 0.02


def relative_squared_error(images: FloatArray, reference: FloatArray) -> FloatArray:
    """Per pixel (..., h, w), of (..., h, w, 3) against (h, w, 3); its mean is called relMSE.

    (e_r^2 + e_g^2 + e_b^2) / 3 over m^2 + (0.02 M)^2, where m is the mean of the reference's
    channels there and M its mean everywhere.
    """
    squared = ((images - reference) ** 2).mean(axis=-1)
    darkest = DARKEST * reference.mean()
    relative: FloatArray = squared / (reference.mean(axis=-1) ** 2 + darkest**2)
    return relative


def flip_error(image: FloatArray, reference: FloatArray) -> float:
    """Mean HDR-FLIP, 0..1 (Andersson et al. 2021), at 67 pixels per degree.

    The exposures are the reference's. Negative values, which a filter may leave, count as black.
    """
    shown = [np.maximum(picture, 0).astype(np.float32) for picture in (reference, image)]
    _, mean, _ = extra("flip_evaluator").evaluate(*shown, "HDR", applyMagma=False)
    return float(mean)
