"""What single strategies (s, t) add to a picture, and what their errors would add up to."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from etendue.arrays import FloatArray
from etendue.image import Image
from etendue.luminance import luminance
from etendue.validation.claims import BlendEvidence, Claim
from etendue.validation.pairs import Pair
from etendue.validation.results import Strategy
from etendue.validation.shots import Shot, Studio

_NAME = re.compile(r"st\.(weighted|unweighted)\.s(\d+)t(\d+)")

#: The formula of a picture whose strategies are off by their own factors f(s, t).
BLEND = "Σ f(s,t) w C / Σ w C"

Shares = Mapping[Strategy, FloatArray]


def strategy_layers(image: Image, kind: str) -> dict[Strategy, FloatArray]:
    """(h, w, 3) by strategy; `kind` is "weighted" or "unweighted"."""
    layers = {}
    for name in image.strategy_images:
        match = _NAME.fullmatch(name)
        if match and match[1] == kind:
            color = np.asarray(image[name], dtype=np.float64)
            layers[int(match[2]), int(match[3])] = color
    return layers


def shares_of(studio: Studio, shot: Shot, spp: int, takes: int) -> Sequence[Shares]:
    """Of independent renders: luminance (h, w) of every strategy's weighted image."""
    return [
        {
            strategy: luminance(color)
            for strategy, color in strategy_layers(image, "weighted").items()
        }
        for image in studio.images(shot, spp, takes, "shares")
    ]


def blended(
    takes: Sequence[Shares], factor: Callable[[int, int], float]
) -> tuple[FloatArray, FloatArray]:
    """(n,) each: means of the pictures as they are, and with every strategy times its factor."""
    right = [sum(float(share.mean()) for share in shares.values()) for shares in takes]
    wrong = [
        sum(factor(*strategy) * float(share.mean()) for strategy, share in shares.items())
        for shares in takes
    ]
    return np.array(right), np.array(wrong)


def blend_claim(pair: Pair, takes: Sequence[Shares], factor: Callable[[int, int], float]) -> Claim:
    """That the wrong picture is what the right one's weights make of wrong and right strategies.

    `factor` is what leaving the correction out makes of strategy (s, t).
    """
    right, blend = blended(takes, factor)
    evidence = BlendEvidence(pair.wrong, right, blend)
    return Claim(
        name=f"{pair.name}, wrong",
        quantity="wrong / right",
        shot=pair.shot.without(pair.correction),
        formula=BLEND,
        predicted=evidence.predicted,
        evidence=evidence,
    )
