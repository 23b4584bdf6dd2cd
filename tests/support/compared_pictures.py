"""Pictures to be compared."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]

HEIGHT, WIDTH = 32, 48
WATER = 1.333**2


def scene() -> FloatArray:
    """A dark picture with a bright patch, about twice as large as the brightest region."""
    color = np.full((HEIGHT, WIDTH, 3), [0.2, 0.25, 0.3])
    color[8:16, 9:27] = [4.0, 3.5, 3.0]
    return color


def noisy(color: FloatArray, error: float, seed: int) -> FloatArray:
    """Grey noise of so much of each pixel."""
    noise = np.random.default_rng(seed).normal(0, error, color.shape[:2])
    noised: FloatArray = color * (1 + noise[..., None])
    return noised
