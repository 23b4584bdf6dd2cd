"""How much the noise of neighbouring pixels has in common."""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from etendue.arrays import FloatArray

#: Side of the squares, in pixels, that are looked at one by one; B / A may differ between them.
SQUARE = 16
#: Sides of the windows whose sums are compared with those of independent pixels.
SMALL, LARGE = 2, 4
#: Squares at most: a median of so many is known to a few per cent.
SQUARES = 1024


def noise_correlation(a: FloatArray, b: FloatArray, var_a: FloatArray, var_b: FloatArray) -> float:
    """Factor, at least 1, by which the variance of a sum of many pixels exceeds the pixels' own.

    One light path that splats into several pixels, through a filter wider than one, makes their
    errors alike, which no variance channel tells. Here from how B - r A, over its standard error,
    adds up within windows, with r the ratio of each square of 16 x 16: the median of the squares,
    so that the few where B / A itself changes do not matter. Of the factor of a Gaussian up to a
    pixel wide it finds nine tenths, of wider filters' less. Less than 1 (strata, a fixed number of
    light paths) counts as 1: the interval is then wider than it need be.
    """
    squares = [_squares(values) for values in (a, b, var_a, var_b)]
    lit = (squares[0].sum(axis=(1, 2)) > 0) & (squares[1].sum(axis=(1, 2)) > 0)
    in_a, in_b, in_var_a, in_var_b = (values[lit] for values in squares)
    ratio = in_b.sum(axis=(1, 2), keepdims=True) / in_a.sum(axis=(1, 2), keepdims=True)
    error = np.sqrt(in_var_b + ratio**2 * in_var_a)
    scores = np.divide(in_b - ratio * in_a, error, out=np.zeros_like(error), where=error > 0)
    scores = scores[(scores != 0).any(axis=(1, 2))]
    if not scores.size:
        return 1.0
    # A window of k sees pixels that are d apart (k - d) / k times as often as a large picture does:
    # along each axis too little, by something over k, for the d that a filter spans.
    axis = 2 * sqrt(_excess(scores, LARGE)) - sqrt(_excess(scores, SMALL))
    return max(1.0, axis) ** 2


def _excess(scores: FloatArray, side: int) -> float:
    """Variance of windows' sums over that of independent pixels, as a median of the squares'."""
    sums = sliding_window_view(scores, (side, side), axis=(1, 2)).sum(axis=(-2, -1))
    # The ratio takes the square's mean away, and with it this part of a window's variance.
    independent = side**2 * (1 - (side / SQUARE) ** 2)
    factors = (sums**2).mean(axis=(1, 2)) / independent / (scores**2).mean(axis=(1, 2))
    return float(np.median(factors))


def _squares(values: FloatArray) -> FloatArray:
    """(h, w) to (n, SQUARE, SQUARE), evenly chosen; what is left at the borders is left out."""
    rows, columns = (size // SQUARE for size in values.shape)
    every = max(1, round(rows * columns / SQUARES))
    whole = values[: rows * SQUARE, : columns * SQUARE]
    grid = whole.reshape(rows, SQUARE, columns, SQUARE).swapaxes(1, 2)
    chosen = np.arange(0, rows * columns, every)
    squares: FloatArray = grid[chosen // max(columns, 1), chosen % max(columns, 1)]
    return squares
