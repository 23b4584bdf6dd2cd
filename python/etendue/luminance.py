"""Relative luminance of scene-linear Rec.709, and ratios of it."""

from __future__ import annotations

import numpy as np

from etendue.arrays import FloatArray, Pixels

REC709 = np.array([0.2126, 0.7152, 0.0722])


def luminance(color: Pixels) -> FloatArray:
    """(..., 3) to (...). Sums in doubles without a copy of all channels in doubles."""
    weighted: FloatArray = np.einsum("...c,c->...", color, REC709, dtype=np.float64)
    return weighted


def quotient(top: FloatArray, below: FloatArray) -> FloatArray:
    """Of the same shape; NaN where there is nothing to divide by."""
    result: FloatArray = np.full(below.shape, np.nan)
    np.divide(top, below, out=result, where=below > 0)
    return result
