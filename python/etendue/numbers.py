"""Numbers for people."""

from __future__ import annotations

from math import isfinite

_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def short(value: float) -> str:
    """1.777, or 2.3 × 10⁻⁵."""
    if not isfinite(value):
        return "unknown"
    if value != 0 and not 1e-3 <= abs(value) < 1e6:
        return _scientific(value)
    return f"{value:.4g}" if abs(value) < 1e4 else f"{value:,.0f}"


def probability(value: float) -> str:
    """Two digits; what no computer tells from 0 is not called 0."""
    if not isfinite(value):
        return "unknown"
    if value < 1e-300:
        return "< 10⁻³⁰⁰"
    return f"{value:.2g}" if value >= 1e-3 else _scientific(value, 1)


def _scientific(value: float, places: int = 2) -> str:
    mantissa, exponent = f"{value:.{places}e}".split("e")
    return f"{mantissa} × 10{str(int(exponent)).translate(_SUPERSCRIPTS)}"


def percent(share: float) -> str:
    """Three digits."""
    return f"{100 * share:.3g} %"


def counted(number: int, noun: str) -> str:
    """With its noun: "1 check", "2,000 checks"."""
    return f"{number:,} {noun}" if number == 1 else f"{number:,} {noun}s"
