"""How far renders are from what they converge to."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

#: A pixel darker than this part of the mean counts about as that bright: black divides by zero.
DARKEST = 0.02
#: Part of a render's pixels, the farthest off, that the robust figure leaves out.
TRIMMED = 0.001


@dataclass(frozen=True)
class RelMse:
    """Mean over renders."""

    whole: float
    robust: float  #: without each render's worst pixels: else one firefly may be the figure


def rel_mse(images: npt.ArrayLike, reference: npt.ArrayLike) -> RelMse:
    """Of renders (n, h, w, 3) against (h, w, 3).

    A pixel's error is (e_r^2 + e_g^2 + e_b^2) / 3 over m^2 + (0.02 M)^2, where m is the mean of the
    reference's channels there and M its mean everywhere; the figure is the mean over pixels.
    """
    target = np.asarray(reference, dtype=np.float64)
    squared = ((np.asarray(images, dtype=np.float64) - target) ** 2).mean(axis=-1)
    relative = squared / (target.mean(axis=-1) ** 2 + (DARKEST * target.mean()) ** 2)
    ordered = np.sort(relative.reshape(len(relative), -1), axis=1)
    kept = round((1 - TRIMMED) * ordered.shape[1])
    return RelMse(float(ordered.mean()), float(ordered[:, :kept].mean()))
