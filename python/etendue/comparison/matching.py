"""Which pictures can be compared."""

from __future__ import annotations

import numpy as np

from etendue.comparison.picture import Picture
from etendue.exceptions import ComparisonError

#: Of chromaticities: files round them.
_SAME = 1e-3


def check_match(first: Picture, second: Picture) -> None:
    """Raises ComparisonError, naming both, unless they show the same window of an image in the same
    colour space."""
    if why := _mismatch(first, second):
        raise ComparisonError(f"{first.file} and {second.file} do not match: {why}")


def check_lit(picture: Picture) -> None:
    """Raises ComparisonError, naming it, for a picture without light: nothing relates to it."""
    if picture.luminance.mean() <= 0:
        raise ComparisonError(f"{picture.file}: is black, so it has no ratio to another picture")


def _mismatch(first: Picture, second: Picture) -> str:
    if _size(first) != _size(second):
        return f"their sizes are {_size(first)} and {_size(second)}"
    if first.window != second.window:
        return f"they are crops at {first.window[:2]} and {second.window[:2]}"
    if not np.allclose(first.chromaticities, second.chromaticities, rtol=0, atol=_SAME):
        return "their primaries (the attribute chromaticities) differ"
    return ""


def _size(picture: Picture) -> str:
    x0, y0, x1, y1 = picture.window
    return f"{x1 - x0}x{y1 - y0}"
