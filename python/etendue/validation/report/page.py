"""The page."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from etendue.html import common_exposure, legend, picture_url, ratio_map_url, rendered
from etendue.html.drawing import FONT_SIZE
from etendue.interval import interval_text
from etendue.numbers import counted, percent, probability, short
from etendue.progress import duration
from etendue.validation.report.intervals import marks
from etendue.validation.report.plots import plot_url
from etendue.validation.report.pyramids import BRIGHTER, levels
from etendue.validation.report.verdicts import case_verdict, held, verdict
from etendue.validation.results import Figure, PicturePair, Plot, ValidationResult

_TEMPLATE = Path(__file__).parent / "report.html.j2"


def as_html(result: ValidationResult) -> str:
    """Raises Error when the extra `report` is missing."""
    return rendered(
        _TEMPLATE,
        {
            "result": result,
            "verdict": verdict(result),
            "case_verdict": case_verdict,
            "figures": {
                case.name: [_figure(figure) for figure in case.figures] for case in result.cases
            },
            "marks": {case.name: marks(case.checks) for case in result.cases},
            "plot_font_size": FONT_SIZE,
            "pyramid_brighter": BRIGHTER,
            "held": held,
            "counted": counted,
            "duration": duration,
            "interval": interval_text,
            "percent": percent,
            "probability": probability,
            "short": short,
        },
    )


def _figure(figure: Figure) -> dict[str, Any]:
    """What the templates show of it; `kind` says which template."""
    shown: dict[str, Any] = {"title": figure.title, "caption": figure.caption}
    if isinstance(figure, PicturePair):
        return shown | {"kind": "pair"} | _pair(figure)
    if isinstance(figure, Plot):
        return shown | {"kind": "plot", "url": plot_url(figure)}
    return shown | {"kind": "pyramid", "levels": levels(figure)}


def _pair(pair: PicturePair) -> dict[str, Any]:
    exposure = common_exposure(pair.right, pair.wrong)
    maps = [("wrong / right, measured", pair.ratio)]
    if pair.predicted_ratio is not None:
        maps.append(("wrong / right, predicted", pair.predicted_ratio))
    height, width = pair.ratio.shape
    return {
        "right": picture_url(pair.right, exposure),
        "wrong": picture_url(pair.wrong, exposure),
        "maps": [(name, ratio_map_url(ratio, pair.full_scale)) for name, ratio in maps],
        "legend": legend(pair.full_scale),
        "width": width,
        "height": height,
    }
