"""The outcome, candidate by candidate, for a terminal."""

from __future__ import annotations

from math import isfinite

from rich.table import Table
from rich.text import Text

from etendue.tradeoff.report.words import error_percent
from etendue.tradeoff.results import TradeoffResult

_STYLES = {"converges": "green", "floor": "bold red", "unknown": "yellow"}


def summary_table(result: TradeoffResult) -> Table:
    table = Table()
    table.add_column("candidate", style="bold", no_wrap=True)
    for name in ("error", "slope", "efficiency"):
        table.add_column(name, justify="right", no_wrap=True)
    table.add_column("verdict", no_wrap=True)
    for found in result.candidates:
        table.add_row(
            Text(found.name),
            error_percent(found.rungs[-1].rel_mse.value),
            _told(found.slope.value, ".2f"),
            _told(found.relative_efficiency.value, ".2g"),
            Text(found.verdict, _STYLES[found.verdict]),
        )
    return table


def _told(value: float, digits: str) -> str:
    return format(value, digits) if isfinite(value) else "unknown"
