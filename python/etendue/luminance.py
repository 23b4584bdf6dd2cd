"""Relative luminance of scene-linear Rec.709."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]

REC709 = np.array([0.2126, 0.7152, 0.0722])


def luminance(color: FloatArray) -> FloatArray:
    """(..., 3) to (...)."""
    weighted: FloatArray = color @ REC709
    return weighted
