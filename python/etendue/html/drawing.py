"""Drawings (SVG) in one style, for pages."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any

from etendue.extras import extra
from etendue.html.pictures import data_url

#: CSS pixels: a phone's width, so that no label is drawn smaller than it is written.
WIDTH, HEIGHT = 366, 300
#: CSS pixels, of all that is written in a drawing.
FONT_SIZE = 12.5
#: Points per CSS pixel.
_POINT = 0.75

#: Okabe and Ito, "Color Universal Design" (2008): told apart by all kinds of colour vision. Without
#: the yellow, too light for a line on white.
COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")
#: So that a print without colours tells them apart, too.
MARKERS = ("o", "s", "^", "D", "v", "P", "X")
DASHES = ("-", (0, (6, 2)), (0, (2, 1.5)), (0, (7, 2, 1.5, 2)))

_STYLE = {
    "svg.fonttype": "none",
    "svg.hashsalt": "etendue",
    "font.family": "sans-serif",
    "font.size": FONT_SIZE * _POINT,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": "#5a636e",
    "axes.linewidth": 0.8,
    "axes.labelsize": "medium",
    "xtick.labelsize": "medium",
    "ytick.labelsize": "medium",
    "legend.fontsize": "medium",
    "axes.labelcolor": "#1b1f24",
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e3e7eb",
    "grid.linewidth": 0.7,
    "xtick.color": "#5a636e",
    "ytick.color": "#5a636e",
    "xtick.labelcolor": "#1b1f24",
    "ytick.labelcolor": "#1b1f24",
    "legend.frameon": False,
    "lines.linewidth": 1.6,
    "lines.markersize": 5,
}


def drawing_url(draw: Callable[[Any], None], height: int = HEIGHT) -> str:
    """Of what `draw` puts into a Matplotlib figure, WIDTH by `height` CSS pixels."""
    with extra("matplotlib").rc_context(_STYLE):
        figure = extra("matplotlib.figure").Figure(
            figsize=(WIDTH * _POINT / 72, height * _POINT / 72), layout="constrained"
        )
        draw(figure)
        buffer = io.BytesIO()
        figure.savefig(buffer, format="svg", metadata={"Date": None})
    return data_url("image/svg+xml", buffer.getvalue())
