"""What came out, in words that the page and the terminal share."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from etendue.numbers import counted, probability
from etendue.validation.results import CaseResult, Check, ValidationResult


def verdict(result: ValidationResult) -> str:
    """As in "All 42 predictions hold", "2 of 42 predictions do not hold"."""
    told = _told(result)
    left = len(result.not_run)
    return f"{told}; interrupted, {counted(left, 'case')} not run" if left else told


def _told(result: ValidationResult) -> str:
    total = len(result.checks)
    if total == 0:
        return "Nothing was predicted"
    failed = total - held(result.checks)
    if failed:
        verb = "does" if failed == 1 else "do"
        return f"{failed} of {counted(total, 'prediction')} {verb} not hold"
    return f"All {counted(total, 'prediction')} hold" if total > 1 else "The prediction holds"


def case_verdict(case: CaseResult) -> Literal["holds", "fails", "measured"]:
    """A case without predictions, such as what something costs, only measures."""
    if not case.checks:
        return "measured"
    return "holds" if case.passed else "fails"


def held(checks: Sequence[Check]) -> int:
    return sum(check.passed for check in checks)


def worst_p_value(checks: Sequence[Check]) -> str:
    """The smallest."""
    return probability(min(check.p_value for check in checks)) if checks else "none"
