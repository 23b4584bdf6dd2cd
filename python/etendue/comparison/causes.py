"""Factors that a renderer may have forgotten, and what they would make of the picture."""

from __future__ import annotations

from collections.abc import Iterator

from etendue.comparison.ratio import Ratio

INDICES = {"water": 1.333, "glass": 1.5, "diamond": 2.42}


def likely_causes(ratio: Ratio) -> tuple[str, ...]:
    """The factors within the interval, as text; none when no difference would explain it as well.

    A match is no proof: other errors may make the same number (theory.md §5).
    """
    if not ratio.known or 1 in ratio:
        return ()
    return tuple(cause for cause, factor in _factors() if factor in ratio)


def _factors() -> Iterator[tuple[str, float]]:
    for name, eta in INDICES.items():
        of = f"(η = {eta:g}, {name})"
        yield f"one uncancelled η² = {eta**2:.4g} {of}", eta**2
        yield f"one uncancelled η⁻² = {eta**-2:.4g} {of}", eta**-2
        yield f"two uncancelled η², η⁴ = {eta**4:.4g} {of}", eta**4
