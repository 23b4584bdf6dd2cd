"""The figures of a Comparison, for people."""

from __future__ import annotations

from rich.table import Table
from rich.text import Text

from etendue.comparison.comparison import Comparison
from etendue.comparison.distance import Distance
from etendue.comparison.picture import Picture
from etendue.comparison.ratio import Ratio
from etendue.comparison.to_dict import beyond
from etendue.interval import interval_text

_METHODS = {"variance": "variance channels", "jackknife": "jackknife over tiles"}


def figures(found: Comparison) -> list[tuple[str, str]]:
    """Names and values."""
    rows = [
        ("A", _picture(found.a)),
        ("B", _picture(found.b)),
        ("mean B / A", _ratio(found.whole)),
        ("B / A, brightest region", _ratio(found.brightest)),
        ("B from A", _distance(found.b_from_a)),
    ]
    if found.reference is not None:
        rows.insert(2, ("reference", _picture(found.reference)))
    if found.a_from_reference is not None:
        rows.append(("A from the reference", _distance(found.a_from_reference)))
    if found.b_from_reference is not None:
        rows.append(("B from the reference", _distance(found.b_from_reference)))
    rows.append(("z-scores", _z_scores(found)))
    return rows


def comparison_table(found: Comparison) -> Table:
    """For a terminal."""
    table = Table(show_header=False)
    table.add_column(style="bold")
    table.add_column(overflow="fold")
    for name, value in figures(found):
        table.add_row(name, Text(value))
    return table


def _picture(picture: Picture) -> str:
    return f"{picture.file}, layer {picture.layer}" if picture.layer else picture.file


def _ratio(ratio: Ratio) -> str:
    known = interval_text(ratio)
    return f"{known} ({ratio.level:.0%}, {_METHODS[ratio.method]}, {ratio.pixels:,} pixels)"


def _distance(distance: Distance) -> str:
    flip = "not measured" if distance.flip is None else f"{distance.flip:.4f}"
    return f"relMSE {distance.rel_mse:.4g}, FLIP {flip}"


def _z_scores(found: Comparison) -> str:
    if found.z_scores is None:
        return "none: not both files have variance channels"
    return (
        f"{beyond(found.z_scores, 3):.2%} of pixels' channels beyond ±3 "
        "(noise alone: 0.3%, or 1% where variances come from as few as eight parts)"
    )
