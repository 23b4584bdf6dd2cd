"""Where a picture is brightest."""

from __future__ import annotations

from math import ceil

import numpy as np
import numpy.typing as npt

from etendue.comparison.picture import FloatArray
from etendue.extras import extra

BoolArray = npt.NDArray[np.bool_]

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
    chosen = np.zeros(guide.size, dtype=np.bool_)
    order = np.argsort(-around, axis=None, kind="stable")
    chosen[order[: ceil(BRIGHTEST * guide.size)]] = True
    return chosen.reshape(guide.shape)
