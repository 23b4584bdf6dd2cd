"""The outcome in plain words."""

from __future__ import annotations

from collections.abc import Sequence

from etendue.comparison.causes import INDICES, fitting_causes, likely_cause
from etendue.comparison.ratio import Ratio
from etendue.comparison.region import BRIGHTEST
from etendue.interval import interval_text

REGION = f"in the brightest {BRIGHTEST * 100:g} % of the pixels"
WHOLE = "over the whole picture"


def sentence(whole: Ratio, brightest: Ratio, indices: Sequence[float] = INDICES) -> str:
    """Of the brightest region, where an uncancelled factor shows, and of the whole picture."""
    sure = f"({whole.level:.0%} confidence each)"
    remark = _remark(brightest, indices)
    if brightest.known and whole.known and remark == _remark(whole, indices):
        return f"{_told(REGION, brightest)} and {interval_text(whole)} × {WHOLE} {sure}{remark}."
    parts = [
        f"{_told(where, ratio)}{_remark(ratio, indices)}"
        for where, ratio in ((REGION, brightest), (WHOLE, whole))
    ]
    return f"{'; '.join(parts)} {sure}."


def _told(where: str, ratio: Ratio) -> str:
    if not ratio.known:
        return f"noise hides the ratio {where}"
    return f"B is {interval_text(ratio)} × as bright as A {where}"


def _remark(ratio: Ratio, indices: Sequence[float]) -> str:
    if not ratio.known:
        return ""
    if 1 in ratio:
        return ": no difference is resolved"
    if cause := likely_cause(ratio, indices):
        return f": possibly {cause}"
    if fitting_causes(ratio, indices):
        return ", too uncertain to name a cause"
    return ""
