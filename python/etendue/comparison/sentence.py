"""The outcome in plain words."""

from __future__ import annotations

from etendue.comparison.causes import likely_causes
from etendue.comparison.ratio import Ratio
from etendue.interval import interval_text


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
        return f"no difference is resolved {where}: B is {interval_text(ratio)} × as bright as A"
    told = f"B is {interval_text(ratio)} × as bright as A {where}"
    causes = likely_causes(ratio)
    return f"{told}: possibly {', or '.join(causes)}" if causes else told
