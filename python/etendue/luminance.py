"""Relative luminance of scene-linear Rec.709."""

from __future__ import annotations

import numpy as np

from etendue.arrays import FloatArray, Pixels

REC709 = np.array([0.2126, 0.7152, 0.0722])


def luminance(color: Pixels) -> FloatArray:
    """(..., 3) to (...). Sums in doubles without a copy of all channels in doubles."""
    weighted: FloatArray = np.einsum("...c,c->...", color, REC709, dtype=np.float64)
    return weighted
