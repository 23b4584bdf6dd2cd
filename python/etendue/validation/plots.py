"""Series of plots from estimates."""

from __future__ import annotations

from collections.abc import Sequence

from etendue.validation.results import Estimate, Series


def measured_series(label: str, points: Sequence[tuple[float, Estimate]]) -> Series:
    """Of (x, estimate)."""
    return Series(
        label,
        tuple(x for x, _ in points),
        tuple(estimate.value for _, estimate in points),
        tuple(estimate.low for _, estimate in points),
        tuple(estimate.high for _, estimate in points),
    )
