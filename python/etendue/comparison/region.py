"""Where a picture is brightest."""

from __future__ import annotations

from math import ceil

import numpy as np

from etendue.arrays import BoolArray, FloatArray
from etendue.extras import extra

#: Part of the pixels that is called the brightest region.
BRIGHTEST = 0.05
#: Side of the square whose pixels judge the one in its middle.
NEIGHBOURS = 5


def brightest_region(guide: FloatArray) -> BoolArray:
    """(h, w): the twentieth of the pixels that have the brightest neighbours in the guide (h, w).

    A pixel's own value has no say: else pixels would be chosen for their noise, and a sum over the
    region would be too bright in whichever picture is the noisier one.
    """
    count = NEIGHBOURS**2
    # Mirrored, not repeated, at the border: a repeated pixel would be its own neighbour.
    means = extra("scipy.ndimage").uniform_filter(guide, NEIGHBOURS, mode="mirror")
    around = (count * means - guide) / (count - 1)
    wanted = ceil(BRIGHTEST * guide.size)
    chosen = np.zeros(guide.size, dtype=np.bool_)
    # A partition: of eight million pixels a sort takes ten times as long.
    chosen[np.argpartition(around, guide.size - wanted, axis=None)[guide.size - wanted :]] = True
    return chosen.reshape(guide.shape)
