"""What is compared."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from etendue.luminance import luminance

FloatArray = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Picture:
    """A file's colour, scene-linear and taken for Rec.709, row 0 on top. All values are finite."""

    file: str
    window: tuple[int, int, int, int]
    """(x0, y0, x1, y1) within the full image, x1 and y1 excluded."""
    color: FloatArray
    """(h, w, 3)"""
    variance: FloatArray | None
    """(h, w, 3), of the pixels' means; None when the file does not know it."""

    @property
    def luminance(self) -> FloatArray:
        """(h, w)"""
        return luminance(self.color)

    @property
    def luminance_variance(self) -> FloatArray | None:
        """(h, w), an upper bound: what the channels have in common no file tells.

        Noise that is the same in all of them, as a path tracer's nearly is where light is white,
        attains the bound.
        """
        return None if self.variance is None else luminance(np.sqrt(self.variance)) ** 2
