"""The outcome in plain words."""

from __future__ import annotations

from math import floor, log10

from etendue.comparison.causes import likely_causes
from etendue.comparison.ratio import Ratio


def sentence(whole: Ratio, brightest: Ratio) -> str:
    """Of the brightest region, where an uncancelled factor shows, and of the whole picture."""
    parts = [
        _told("inside the brightest region", brightest),
        _told("over the whole picture", whole),
    ]
    return f"{parts[0]}; {parts[1]} ({whole.level:.0%} confidence)."


def _told(where: str, ratio: Ratio) -> str:
    if not ratio.known:
        return f"noise hides the ratio {where}"
    if 1 in ratio:
        return f"no difference is resolved {where}: B is {interval(ratio)} × as bright as A"
    told = f"B is {interval(ratio)} × as bright as A {where}"
    causes = likely_causes(ratio)
    return f"{told}: possibly {', or '.join(causes)}" if causes else told


def interval(ratio: Ratio) -> str:
    """'1.78 ± 0.01': the uncertainty to two digits at most, the value to as many places.

    Fieller's interval lies a little to one side; the longer of its arms is shown.
    """
    arm = max(ratio.high - ratio.value, ratio.value - ratio.low)
    # A double of a float's precision has no more to tell.
    places = 6 if arm <= 0 else min(6, max(0, 1 - floor(log10(arm))))
    return f"{ratio.value:.{places}f} ± {arm:.{places}f}"
