"""A Plot as a drawing (SVG): predictions are lines, measurements points with error bars."""

from __future__ import annotations

import io
from typing import Any

import numpy as np

from etendue.extras import extra
from etendue.html.pictures import data_url
from etendue.validation.results import Plot, Series

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
_MARKERS = ("o", "s", "^", "D", "v", "P", "X")
_DASHES = ("-", (0, (6, 2)), (0, (2, 1.5)), (0, (7, 2, 1.5, 2)))

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


def plot_url(plot: Plot) -> str:
    with extra("matplotlib").rc_context(_STYLE):
        figure = extra("matplotlib.figure").Figure(
            figsize=(WIDTH * _POINT / 72, HEIGHT * _POINT / 72), layout="constrained"
        )
        _draw(figure, plot)
        buffer = io.BytesIO()
        figure.savefig(buffer, format="svg", metadata={"Date": None})
    return data_url("image/svg+xml", buffer.getvalue())


def _draw(figure: Any, plot: Plot) -> None:
    axes = figure.subplots()
    axes.set_xlabel(plot.x_label)
    axes.set_ylabel(plot.y_label)
    if plot.log_y:
        _make_logarithmic(axes)
    labels = list(dict.fromkeys(series.label for series in (*plot.predicted, *plot.measured)))
    drawn: dict[str, list[Any]] = {label: [] for label in labels}
    for series in plot.predicted:
        drawn[series.label].append(_curve(axes, series, labels.index(series.label)))
    for series in plot.measured:
        drawn[series.label].append(_points(axes, series, labels.index(series.label)))
    if len(labels) > 1:
        figure.legend(
            [tuple(parts) for parts in drawn.values()],
            labels,
            loc="outside upper left",
            ncols=2,
            handlelength=2.6,
            columnspacing=1.2,
        )


def _make_logarithmic(axes: Any) -> None:
    """With ticks at 0.5, 1, 2, 5: ratios lie within a decade or two."""
    ticker = extra("matplotlib.ticker")
    axes.set_yscale("log")
    axes.yaxis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value:g}"))
    axes.yaxis.set_minor_locator(ticker.NullLocator())


def _curve(axes: Any, series: Series, index: int) -> Any:
    (line,) = axes.plot(
        series.x,
        series.y,
        color=COLORS[index % len(COLORS)],
        linestyle=_DASHES[index % len(_DASHES)],
        # A single prediction has no line.
        marker="_" if len(series.x) == 1 else "",
        markersize=16,
    )
    return line


def _points(axes: Any, series: Series, index: int) -> Any:
    y = np.asarray(series.y)
    arms = None
    if series.low and series.high:
        arms = np.maximum(0, [y - np.asarray(series.low), np.asarray(series.high) - y])
    return axes.errorbar(
        series.x,
        y,
        yerr=arms,
        fmt=_MARKERS[index % len(_MARKERS)],
        color=COLORS[index % len(COLORS)],
        markeredgecolor="white",
        markeredgewidth=0.6,
        elinewidth=1.1,
        capsize=2.5,
    )
