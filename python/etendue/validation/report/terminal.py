"""The outcome, case by case, for a terminal."""

from __future__ import annotations

from rich.table import Table
from rich.text import Text

from etendue.validation.report.verdicts import case_verdict, held, verdict, worst_p_value
from etendue.validation.results import ValidationResult

_STYLES = {"holds": "green", "fails": "bold red", "measured": ""}


def summary_table(result: ValidationResult) -> Table:
    table = Table(caption=Text(verdict(result)))
    table.add_column("case", style="bold", no_wrap=True)
    table.add_column("checks", justify="right", no_wrap=True)
    table.add_column("worst p", justify="right", no_wrap=True)
    table.add_column("prediction", overflow="fold")
    table.add_column("verdict", no_wrap=True)
    for case in result.cases:
        table.add_row(
            Text(case.name),
            f"{held(case.checks)}/{len(case.checks)}" if case.checks else "",
            worst_p_value(case.checks),
            Text(case.headline),
            Text(case_verdict(case), _STYLES[case_verdict(case)]),
        )
    return table
