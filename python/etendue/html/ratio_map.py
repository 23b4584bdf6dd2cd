"""Ratios of two pictures, pixel by pixel, in colours: blue darker, white equal, red brighter."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from etendue.arrays import BoolArray, FloatArray
from etendue.extras import extra
from etendue.html.pictures import png_url

#: Blue and red of equal lightness tell all kinds of colour vision apart.
_COLORS = "RdBu_r"
#: Entries of the palette: an odd number of colours, so that equal is exactly white.
_STEPS = 253
_OUTLINE, _NOTHING = _STEPS, _STEPS + 1
_OUTLINE_COLOR, _NOTHING_COLOR = (0, 0, 0), (128, 128, 128)


@dataclass(frozen=True)
class Legend:
    """The colour bar of a ratio map, which is even in the logarithm."""

    stops: tuple[str, ...]
    """CSS colours at equal distances, darker first."""
    labels: tuple[str, ...]
    """At equal distances, both ends included."""
    nothing: str
    """CSS colour where there is nothing to divide."""


def legend(full_scale: float) -> Legend:
    ticks = full_scale ** np.linspace(-1, 1, 5)
    labels = [f"{tick:.3g}" for tick in ticks]
    labels[0], labels[-1] = f"≤ {labels[0]}", f"≥ {labels[-1]}"
    colors = extra("matplotlib").colormaps[_COLORS](np.linspace(0, 1, 11))
    to_hex = extra("matplotlib.colors").to_hex
    return Legend(
        stops=tuple(to_hex(color) for color in colors),
        labels=tuple(f"{label} ×" for label in labels),
        nothing=to_hex(np.divide(_NOTHING_COLOR, 255)),
    )


def ratio_map_url(ratio: FloatArray, full_scale: float, outlined: BoolArray | None = None) -> str:
    """Of (h, w), one pixel for each; NaN is grey. The edge of the region outlined is black."""
    entries = _palette_entries(ratio, full_scale)
    if outlined is not None:
        entries[_edge(outlined)] = _OUTLINE
    image = extra("PIL.Image").fromarray(entries)
    image.putpalette(_palette())
    return png_url(image)


def _palette_entries(ratio: FloatArray, full_scale: float) -> npt.NDArray[np.uint8]:
    # What is black or negative, far below the bar's end, is shown as its end.
    logs = np.log(np.maximum(ratio, full_scale**-2)) / np.log(full_scale)
    steps = np.clip((logs + 1) / 2, 0, 1) * (_STEPS - 1)
    entries: npt.NDArray[np.uint8] = np.where(np.isnan(ratio), _NOTHING, np.round(steps)).astype(
        np.uint8
    )
    return entries


def _palette() -> list[int]:
    colors = extra("matplotlib").colormaps[_COLORS](np.linspace(0, 1, _STEPS), bytes=True)[:, :3]
    return [*map(int, colors.ravel()), *_OUTLINE_COLOR, *_NOTHING_COLOR]


def _edge(region: BoolArray) -> BoolArray:
    """The pixels of the region that have a neighbour outside; the picture's end is none."""
    padded = np.pad(region, 1, mode="edge")
    inside = padded[:-2, 1:-1] & padded[2:, 1:-1] & padded[1:-1, :-2] & padded[1:-1, 2:]
    return region & ~inside
