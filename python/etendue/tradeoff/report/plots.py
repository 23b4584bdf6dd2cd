"""Error against time, as drawings."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from etendue.extras import extra
from etendue.html.drawing import COLORS, DASHES, MARKERS, drawing_url
from etendue.tradeoff.candidates import DEFAULT
from etendue.tradeoff.results import CandidateResult, TradeoffResult, is_known

#: CSS pixels.
_TALL, _LOW = 430, 260
#: Highest over lowest error shown: what is beyond is bad enough, and would flatten all else.
_SHOWN = 3e4
_GREY = "#b9c0c7"
_GUIDE, _FRONT = "slope -1", "best at its time"


def overview_url(result: TradeoffResult) -> str:
    """All candidates; those that matter most in colour."""
    shown = highlighted(result)
    return drawing_url(lambda figure: _overview(figure, result, shown), _TALL)


def single_url(result: TradeoffResult, name: str) -> str:
    """One candidate in colour, all others in grey."""
    return drawing_url(lambda figure: _single(figure, result, name), _LOW)


def highlighted(result: TradeoffResult) -> tuple[str, ...]:
    """Names: the best ones at any time, the default, what differs in kind, then those that do not
    converge; as many as there are colours."""
    wanted = [choice.best for choice in result.choices]
    wanted += [DEFAULT, "path", "light"]
    wanted += [found.name for found in result.candidates if found.verdict != "converges"]
    measured = {found.name for found in result.candidates}
    unique = [name for name in dict.fromkeys(wanted) if name in measured]
    return tuple(unique[: len(COLORS) - 1])


def _overview(figure: Any, result: TradeoffResult, shown: Sequence[str]) -> None:
    axes = _axes(figure, result)
    drawn = {_FRONT: _front(axes, result)}
    for found in result.candidates:
        if found.name not in shown:
            drawn["others"] = _faint(axes, found)
    drawn[_GUIDE] = _guide(axes, result)
    for index, name in enumerate(shown):
        drawn[name] = _strong(axes, result[name], index)
    labels = [label for label in (*shown, "others", _FRONT, _GUIDE) if drawn.get(label)]
    if not labels:
        return
    figure.legend(
        [drawn[label] for label in labels],
        labels,
        loc="outside upper left",
        ncols=2,
        handlelength=2.6,
        columnspacing=1.2,
    )


def _single(figure: Any, result: TradeoffResult, name: str) -> None:
    axes = _axes(figure, result)
    for found in result.candidates:
        if found.name != name:
            _faint(axes, found)
    _strong(axes, result[name], 0)


def _axes(figure: Any, result: TradeoffResult) -> Any:
    axes = figure.subplots()
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("time of one render, seconds")
    axes.set_ylabel("squared error, relMSE")
    formatter = extra("matplotlib.ticker").FuncFormatter(lambda value, _: f"{value:g}")
    axes.xaxis.set_major_formatter(formatter)
    points = [point for found in result.candidates for point in _points(found)]
    if points:
        x, y = zip(*points, strict=True)
        axes.set_xlim(min(x) / 1.3, max(x) * 3)
        axes.set_ylim(min(y) / 3, min(max(y) * 2, min(y) * _SHOWN))
    # Named like the claim of a render: the root, as a share of the brightness.
    percents = axes.secondary_yaxis(
        "right", functions=(lambda e: 100 * np.sqrt(np.maximum(e, 0)), lambda p: (p / 100) ** 2)
    )
    percents.yaxis.set_major_formatter(
        extra("matplotlib.ticker").FuncFormatter(lambda value, _: f"{value:g} %")
    )
    # Most of the time of drawing goes into them.
    for drawn in (axes, percents):
        drawn.minorticks_off()
    return axes


def _points(found: CandidateResult) -> list[tuple[float, float]]:
    """(seconds, relMSE), of what a logarithm shows."""
    rungs = (*found.rungs, found.pooled)
    return [
        (rung.seconds, rung.rel_mse.value)
        for rung in rungs
        if rung.seconds > 0 and rung.rel_mse.value > 0
    ]


def _faint(axes: Any, found: CandidateResult) -> Any:
    """None where there is nothing to draw."""
    points = _points(found)
    if not points:
        return None
    (line,) = axes.plot(*np.array(points).T, color=_GREY, linewidth=1, zorder=1)
    return line


def _front(axes: Any, result: TradeoffResult) -> Any:
    """A broad line under the lowest curves; None where they are of errors that are not seen."""
    line = None
    for span in result.front:
        curve = result[span.best].curve
        if not curve.noise.value > 0:
            continue
        x = np.geomspace(span.begin, span.end, 20)
        (line,) = axes.plot(
            x, curve.noise.value / x + curve.floor, color="#d5e3ef", linewidth=7, zorder=0
        )
    return line


def _guide(axes: Any, result: TradeoffResult) -> Any:
    """A line of slope -1, through the best point's error; None without points."""
    points = [point for found in result.candidates for point in _points(found)]
    if not points:
        return None
    best = min(points, key=lambda point: point[0] * point[1])
    x = np.array(axes.get_xlim())
    (line,) = axes.plot(
        x, best[0] * best[1] / x / 2, color="#5a636e", linewidth=1, linestyle=(0, (1, 2)), zorder=0
    )
    return line


def _strong(axes: Any, found: CandidateResult, index: int) -> Any:
    """Points with intervals, the mean of all renders hollow, and the curve on beyond them; None
    without points."""
    if not _points(found):
        return None
    color, marker = COLORS[index % len(COLORS)], MARKERS[index % len(MARKERS)]
    seconds = np.array([rung.seconds for rung in found.rungs])
    errors = np.array([rung.rel_mse.value for rung in found.rungs])
    known = np.array([is_known(rung.rel_mse) for rung in found.rungs])
    # The arms of what is beyond the top would hang there without their point.
    known &= errors <= axes.get_ylim()[1]
    arms = np.array(
        [
            [rung.rel_mse.value - rung.rel_mse.low, rung.rel_mse.high - rung.rel_mse.value]
            for rung in found.rungs
        ]
    ).T
    points = axes.errorbar(
        seconds,
        errors,
        yerr=np.where(known, arms, 0),
        fmt=marker,
        color=color,
        markeredgecolor="white",
        markeredgewidth=0.6,
        elinewidth=1.1,
        capsize=2.5,
    )
    pooled = found.pooled
    axes.plot(
        pooled.seconds, pooled.rel_mse.value, marker=marker, color=color, markerfacecolor="white"
    )
    x = np.geomspace(seconds[0], axes.get_xlim()[1], 50)
    (line,) = axes.plot(
        x,
        found.curve.noise.value / x + found.curve.floor,
        color=color,
        linestyle=DASHES[index % len(DASHES)],
    )
    return points, line
