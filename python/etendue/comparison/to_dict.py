"""A Comparison as plain data."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING

import numpy as np

from etendue.comparison.causes import Cause, fitting_causes, likely_cause
from etendue.json_text import finite

if TYPE_CHECKING:
    from etendue.arrays import Pixels
    from etendue.comparison.comparison import Comparison
    from etendue.comparison.picture import Picture
    from etendue.comparison.ratio import Ratio

#: Goes up when a key goes away or changes its meaning; new keys leave it.
VERSION = 1


def to_dict(found: Comparison) -> dict[str, object]:
    """Numbers, strings, lists; null for what is not known, so that strict JSON holds it.

    version; sentence; identical (every pixel); width, height; a, b, reference (or null): file,
    layer. whole, brightest: luminance of B over that of A as value, low, high (ends of the interval
    at `level`), pixels, method (variance or jackknife), fitting_causes and likely_cause (or null):
    eta, power, factor, text. b_from_a, a_from_reference, b_from_reference (or null): rel_mse, flip
    (or null). z_scores (or null): beyond_3, the share of pixels' channels beyond ±3.
    """
    height, width = found.brightest_region.shape
    distances = ("b_from_a", "a_from_reference", "b_from_reference")
    return {
        "version": VERSION,
        "sentence": found.sentence,
        "identical": found.identical,
        "width": width,
        "height": height,
        "a": _picture(found.a),
        "b": _picture(found.b),
        "reference": None if found.reference is None else _picture(found.reference),
        "whole": _ratio(found.whole, found.indices),
        "brightest": _ratio(found.brightest, found.indices),
        **{
            name: None if getattr(found, name) is None else asdict(getattr(found, name))
            for name in distances
        },
        "z_scores": None if found.z_scores is None else {"beyond_3": beyond(found.z_scores, 3)},
    }


def beyond(scores: Pixels, limit: float) -> float:
    """Share of the scores that are farther from 0."""
    return float(np.mean(np.abs(scores) > limit))


def _picture(picture: Picture) -> dict[str, object]:
    return {"file": picture.file, "layer": picture.layer}


def _ratio(ratio: Ratio, indices: tuple[float, ...]) -> dict[str, object]:
    likely = likely_cause(ratio, indices)
    return {
        "value": finite(ratio.value),
        "low": finite(ratio.low),
        "high": finite(ratio.high),
        "level": ratio.level,
        "pixels": ratio.pixels,
        "method": ratio.method,
        "fitting_causes": [_cause(cause) for cause in fitting_causes(ratio, indices)],
        "likely_cause": None if likely is None else _cause(likely),
    }


def _cause(cause: Cause) -> dict[str, object]:
    return {**asdict(cause), "factor": cause.factor, "text": str(cause)}
