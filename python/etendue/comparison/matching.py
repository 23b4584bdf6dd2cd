"""Which pictures can be compared."""

from __future__ import annotations

from etendue.comparison.picture import Picture
from etendue.exceptions import ComparisonError


def check_match(first: Picture, second: Picture) -> None:
    """Raises ComparisonError, naming both, unless they show the same window of an image."""
    if first.window == second.window:
        return
    if _size(first) == _size(second):
        why = f"they are crops at {first.window[:2]} and {second.window[:2]}"
    else:
        why = f"their sizes are {_size(first)} and {_size(second)}"
    raise ComparisonError(f"{first.file} and {second.file} do not match: {why}")


def check_lit(picture: Picture) -> None:
    """Raises ComparisonError, naming it, for a picture without light: nothing relates to it."""
    if picture.luminance.mean() <= 0:
        raise ComparisonError(f"{picture.file}: is black, so it has no ratio to another picture")


def _size(picture: Picture) -> str:
    x0, y0, x1, y1 = picture.window
    return f"{x1 - x0}x{y1 - y0}"
