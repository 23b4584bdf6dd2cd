"""A picture cut into tiles."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from etendue.comparison.picture import FloatArray

IntArray = npt.NDArray[np.intp]

#: Tiles along each side, as far as there are pixels: enough for a standard error to be known to a
#: few per cent, and large enough for the noise of neighbours (splats, filters) to stay inside.
SIDE = 32


def tile_numbers(height: int, width: int) -> IntArray:
    """(h, w): the number of each pixel's tile, from 0, none left out. Sizes differ by one pixel."""
    rows, columns = min(SIDE, height), min(SIDE, width)
    row = np.arange(height) * rows // height
    column = np.arange(width) * columns // width
    return np.asarray(row[:, None] * columns + column[None, :], dtype=np.intp)


def tile_sums(values: FloatArray, tiles: IntArray) -> FloatArray:
    """Of (h, w), by number."""
    sums: FloatArray = np.bincount(tiles.ravel(), weights=values.ravel()).astype(np.float64)
    return sums
