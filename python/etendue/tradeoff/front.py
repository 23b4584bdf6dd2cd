"""Who is best at which time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import ceil, log10, sqrt

import numpy as np

from etendue.tradeoff.candidates import DEFAULT
from etendue.tradeoff.results import CandidateResult, Choice, Span, is_known
from etendue.validation.results import Estimate

#: Seconds, at the resolution measured.
BUDGETS = (0.3, 1.0, 3.0, 10.0, 60.0, 600.0)

#: Times that the front is looked at: so many in a factor of ten.
_STEPS = 20
#: Of a step, until the time of a change is known to a thousandth.
_HALVINGS = 7


def front(candidates: Sequence[CandidateResult]) -> tuple[Span, ...]:
    """Who is best from when to when (Pareto: nobody is faster and better at once).

    From the first complete pass of anybody to the longest of BUDGETS.
    """
    begin = min(found.pass_seconds for found in candidates)
    end = max(begin, BUDGETS[-1])
    decades = log10(end / begin)
    spans: list[Span] = []
    for seconds in np.geomspace(begin, end, 2 + ceil(_STEPS * decades)):
        # Rounding must not take the first one's only pass away.
        choice = choose(candidates, float(seconds) * (1 + 1e-9))
        assert choice is not None  # the fastest is ready from the start
        if not spans:
            spans.append(Span(choice.best, choice.seconds, choice.seconds))
        elif spans[-1].best != choice.best:
            change = _change(candidates, spans[-1], choice.seconds)
            spans[-1] = replace(spans[-1], end=change)
            spans.append(Span(choice.best, change, choice.seconds))
        else:
            spans[-1] = replace(spans[-1], end=choice.seconds)
    return tuple(spans)


def _change(candidates: Sequence[CandidateResult], before: Span, after: float) -> float:
    """When the best one of before is not the best any more."""
    low, high = before.end, after
    for _ in range(_HALVINGS):
        middle = sqrt(low * high)
        choice = choose(candidates, middle)
        if choice is not None and choice.best == before.best:
            low = middle
        else:
            high = middle
    return low


def expected(found: CandidateResult, seconds: float) -> Estimate:
    """relMSE after so long, by the candidate's curve.

    Of a candidate that need not find all light, the worst is expected beyond the time of all its
    renders together, which is what their mean is worth and as far as a floor was looked for: one as
    high as it can be without having been seen.
    """
    noise, floor = found.curve.noise, found.floor
    low, value, high = 0.0, found.curve.floor, 0.0
    if found.verdict == "floor":
        low, high = max(floor.low, 0.0), floor.high
    elif not found.candidate.complete and seconds > found.pooled.seconds:
        value = high = found.hidden_floor
    return Estimate(
        noise.value / seconds + value,
        noise.low / seconds + low,
        noise.high / seconds + high,
        noise.level,
    )


def choose(candidates: Sequence[CandidateResult], seconds: float) -> Choice | None:
    """Among those that finish a pass in that time; None when nobody does.

    What rests on a few pixels may be far worse than it seems, and is not chosen if there is
    anything else. Errors that are not positive are less than the reference tells: none of them is
    better than another, and the default is preferred.
    """
    ready = [found for found in candidates if found.pass_seconds <= seconds]
    if not ready:
        return None
    sure = [found for found in ready if not found.fireflies] or ready
    ranked = sorted(
        sure, key=lambda found: (max(expected(found, seconds).value, 0.0), found.name != DEFAULT)
    )
    best, others = ranked[0], ranked[1:]
    error = expected(best, seconds)
    as_good = tuple(
        found.name for found in others if not is_known(error) or _reaches(found, seconds, error)
    )
    return Choice(seconds, best.name, error, as_good, seconds > best.pooled.seconds)


def choices(candidates: Sequence[CandidateResult]) -> tuple[Choice, ...]:
    """For all BUDGETS that allow a choice."""
    found = (choose(candidates, seconds) for seconds in BUDGETS)
    return tuple(choice for choice in found if choice is not None)


def _reaches(found: CandidateResult, seconds: float, best: Estimate) -> bool:
    """Its interval has values that the best one's has, too."""
    return expected(found, seconds).low <= best.high
