"""A picture cut into tiles."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from etendue.arrays import FloatArray

IntArray = npt.NDArray[np.intp]

#: Tiles along each side at most: enough for a standard error to be known to a few per cent.
SIDE = 32
#: Pixels along each side of a tile at least, so that what neighbours share of their noise (splats,
#: filters) stays inside but for the edge.
PIXELS = 4


def tile_numbers(height: int, width: int) -> IntArray:
    """(h, w): the number of each pixel's tile, from 0, none left out. Sizes differ by one pixel."""
    rows, columns = _tiles(height), _tiles(width)
    row = np.arange(height) * rows // height
    column = np.arange(width) * columns // width
    return np.asarray(row[:, None] * columns + column[None, :], dtype=np.intp)


def tile_sums(values: FloatArray, tiles: IntArray) -> FloatArray:
    """Of (h, w), by number."""
    sums: FloatArray = np.bincount(tiles.ravel(), weights=values.ravel()).astype(np.float64)
    return sums


def _tiles(pixels: int) -> int:
    return min(SIDE, max(1, pixels // PIXELS))
