"""One line per candidate and time, for spreadsheets and scripts."""

from __future__ import annotations

import csv
import io

from etendue.tradeoff.results import CandidateResult, Rung, TradeoffResult

COLUMNS = (
    "candidate",
    "asked_for",
    "renders",
    "passes",
    "seconds",
    "rel_mse",
    "low",
    "high",
    "level",
    "verdict",
)


def as_csv(result: TradeoffResult) -> str:
    """RFC 4180, numbers to full precision. `renders`: how many are averaged into one picture.

    Of the mean of all renders there is one, and its interval has no ends: low and high are -inf and
    inf.
    """
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(COLUMNS)
    for found in result.candidates:
        for rung in found.rungs:
            writer.writerow(_row(found, rung, 1))
        writer.writerow(_row(found, found.pooled, result.seeds))
    return text.getvalue()


def _row(found: CandidateResult, rung: Rung, renders: int) -> tuple[str | float, ...]:
    error = rung.rel_mse
    return (
        found.name,
        found.candidate.asked_for,
        renders,
        rung.passes,
        float(rung.seconds),
        float(error.value),
        float(error.low),
        float(error.high),
        float(error.level),
        found.verdict,
    )
