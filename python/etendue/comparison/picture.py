"""What is compared."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from etendue.arrays import FloatArray, Pixels
from etendue.luminance import luminance

#: CIE x, y of red, green, blue and white; an EXR file that names none has these.
REC709_CHROMATICITIES = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)


@dataclass(frozen=True, eq=False)
class Picture:
    """A file's colour, scene-linear, row 0 on top. All values are finite."""

    file: str
    window: tuple[int, int, int, int]
    """(x0, y0, x1, y1) within the full image, x1 and y1 excluded."""
    color: Pixels
    """(h, w, 3)"""
    variance: Pixels | None
    """(h, w, 3), of the pixels' means; None when the file does not know it."""
    layer: str = ""
    """What stands before .R, .G and .B in the file; empty for the plain ones."""
    chromaticities: tuple[float, ...] = REC709_CHROMATICITIES
    full_window: tuple[int, int, int, int] | None = None
    """Of the full image, like `window`; None when the picture is all of it."""

    @property
    def whole(self) -> bool:
        """It is no crop."""
        return self.full_window in (None, self.window)

    @cached_property
    def luminance(self) -> FloatArray:
        """(h, w), by Rec.709's weights whatever the primaries: any fixed weights give a ratio."""
        return luminance(self.color)

    @cached_property
    def luminance_variance(self) -> FloatArray | None:
        """(h, w), an upper bound: what the channels have in common no file tells.

        Noise that is the same in all of them, as a path tracer's nearly is where light is white,
        attains the bound.
        """
        return None if self.variance is None else luminance(np.sqrt(self.variance)) ** 2
