"""One line per check, for spreadsheets and scripts."""

from __future__ import annotations

import csv
import io

from etendue.validation.results import CaseResult, Check, ValidationResult

COLUMNS = (
    "case",
    "check",
    "quantity",
    "stage",
    "camera",
    "integrator",
    "corrections_off",
    "formula",
    "predicted",
    "measured",
    "low",
    "high",
    "level",
    "p_value",
    "passed",
    "explanations",
)


def as_csv(result: ValidationResult) -> str:
    """RFC 4180. Lists within a field are separated by "; ", numbers written to full precision."""
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(COLUMNS)
    writer.writerows(_row(case, check) for case in result.cases for check in case.checks)
    return text.getvalue()


def _row(case: CaseResult, check: Check) -> tuple[str | float, ...]:
    measured = check.measured
    return (
        case.name,
        check.name,
        check.quantity,
        check.stage,
        check.camera,
        check.integrator,
        "; ".join(check.corrections_off),
        check.formula,
        float(check.predicted),
        float(measured.value),
        float(measured.low),
        float(measured.high),
        float(measured.level),
        float(check.p_value),
        "yes" if check.passed else "no",
        "; ".join(check.explanations),
    )
