"""How far renders are from what they converge to."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from etendue.comparison.distance import relative_squared_error

#: Part of a render's pixels, the farthest off, that the robust figure leaves out.
TRIMMED = 0.001


@dataclass(frozen=True)
class RelMse:
    """Mean over renders."""

    whole: float
    robust: float  #: without each render's worst pixels: else one firefly may be the figure


def rel_mse(images: npt.ArrayLike, reference: npt.ArrayLike) -> RelMse:
    """Of renders (n, h, w, 3) against (h, w, 3).

    The mean over pixels of relative_squared_error.
    """
    relative = relative_squared_error(
        np.asarray(images, dtype=np.float64), np.asarray(reference, dtype=np.float64)
    )
    ordered = np.sort(relative.reshape(len(relative), -1), axis=1)
    kept = round((1 - TRIMMED) * ordered.shape[1])
    return RelMse(float(ordered.mean()), float(ordered[:, :kept].mean()))
