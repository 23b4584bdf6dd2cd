"""A Plot as a drawing (SVG): predictions are lines, measurements points with error bars."""

from __future__ import annotations

from typing import Any

import numpy as np

from etendue.extras import extra
from etendue.html.drawing import COLORS, DASHES, MARKERS, drawing_url
from etendue.validation.results import Plot, Series


def plot_url(plot: Plot) -> str:
    return drawing_url(lambda figure: _draw(figure, plot))


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
        linestyle=DASHES[index % len(DASHES)],
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
        fmt=MARKERS[index % len(MARKERS)],
        color=COLORS[index % len(COLORS)],
        markeredgecolor="white",
        markeredgewidth=0.6,
        elinewidth=1.1,
        capsize=2.5,
    )
