"""The page."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from etendue.html import common_exposure, legend, picture_url, ratio_map_url, rendered
from etendue.html.drawing import FONT_SIZE
from etendue.interval import interval_text
from etendue.numbers import counted, percent, probability, short
from etendue.tradeoff.candidates import DEFAULT
from etendue.tradeoff.report.plots import overview_url, single_url
from etendue.tradeoff.report.words import (
    cannot_be_concluded,
    choice_sentence,
    efficiency_text,
    error_percent,
    headline,
    longest_choice,
    run_sentence,
    seconds_text,
    size_factor,
    size_sentence,
    slope_sentence,
    verdict_sentence,
    what_default_is,
)
from etendue.tradeoff.results import CandidateResult, TradeoffResult

#: The factor at the ends of the ratio maps' colour bar.
FULL_SCALE = 2.0

_TEMPLATE = Path(__file__).parent / "tradeoff.html.j2"


def as_html(result: TradeoffResult) -> str:
    """Raises Error when the extra `report` is missing."""
    exposure = common_exposure(result.reference.picture)
    longest = longest_choice(result)
    return rendered(
        _TEMPLATE,
        {
            "result": result,
            "stage": Path(result.stage).name,
            "default": DEFAULT,
            "headline": headline(result),
            "reference": picture_url(result.reference.picture, exposure),
            "overview": overview_url(result),
            "cards": [_card(result, found, exposure) for found in result.candidates],
            "legend": legend(FULL_SCALE),
            "cautions": list(cannot_be_concluded(result)),
            "plot_font_size": FONT_SIZE,
            "reasons": _reasons(result),
            "why": None if longest is None else choice_sentence(result, longest),
            "counted": counted,
            "default_sentence": what_default_is(),
            "efficiency_text": efficiency_text,
            "error_percent": error_percent,
            "interval": interval_text,
            "percent": percent,
            "probability": probability,
            "run_sentence": run_sentence,
            "seconds_text": seconds_text,
            "short": short,
            "size_factor": size_factor(result),
            "size_sentence": size_sentence,
            "slope_sentence": slope_sentence,
        },
    )


def _reasons(result: TradeoffResult) -> list[str]:
    """For the choices; what has just been said is not said again."""
    told = [choice_sentence(result, choice) for choice in result.choices]
    return [
        "As above." if number and told[number - 1] == sentence else sentence
        for number, sentence in enumerate(told)
    ]


def _card(result: TradeoffResult, found: CandidateResult, exposure: float) -> dict[str, Any]:
    """What the page shows of a candidate; a map of where it is off if it never gets there."""
    return {
        "found": found,
        "sentence": verdict_sentence(found),
        "picture": picture_url(found.picture, exposure),
        "plot": single_url(result, found.name),
        "map": None if found.verdict == "converges" else ratio_map_url(found.ratio, FULL_SCALE),
    }
