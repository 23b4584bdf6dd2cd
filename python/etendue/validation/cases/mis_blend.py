"""Right and wrong strategies in one picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from etendue.arrays import FloatArray
from etendue.image import Image
from etendue.luminance import luminance, quotient
from etendue.validation.case import Case, Outcome
from etendue.validation.cases.crossings import INTO_WATER, REFRACTION
from etendue.validation.claims import BlendEvidence, BlockEvidence, Claim, is_wrong
from etendue.validation.effort import Effort
from etendue.validation.pairs import same_picture
from etendue.validation.pictures import blocks_of, ratio_map
from etendue.validation.results import PicturePair, Pyramid, Strategy
from etendue.validation.shots import Shot, Studio
from etendue.validation.statistics import Samples
from etendue.validation.strategies import BLEND, strategy_layers

BLOCKS = (3, 4)
EDGES = 3  # lamp, water, floor, eye
#: Of the longest paths in the pyramid.
PYRAMID_EDGES = 5
#: The strategies of that path that are looked at without weights.
ALONE: tuple[Strategy, ...] = ((1, 3), (2, 2), (3, 1))

POOL = Shot(
    stage="caustic_pool.usda",
    camera="/cameras/underwater",
    integrator="bdpt",
    resolution=(32, 24),
    max_depth=EDGES - 1,
    values={
        "/Lights/Lamp.inputs:radius": 1.0,
        "/World/Materials/Water/Surface.inputs:specular_roughness": 0.6,
    },
    strategy_images=EDGES,
    light_paths=0.5,  # more of them would leave little to the camera's side
)


def factor(s: int, _t: int) -> float:
    """What wrong code makes of strategy (s, t): from two vertices on, light paths have crossed."""
    return INTO_WATER if s >= 2 else 1.0


def _blend(image: Image) -> FloatArray:
    """(h, w): luminance that the right weights make of right and wrong strategies."""
    layers = strategy_layers(image, "weighted")
    blend: FloatArray = sum(
        (factor(*strategy) * luminance(color) for strategy, color in layers.items()),
        start=np.zeros((image.height, image.width)),
    )
    return blend


def _claims(studio: Studio, effort: Effort) -> list[Claim]:
    spp = effort.spp(32)
    rights = list(studio.images(POOL, spp, effort.takes))
    wrongs = list(studio.images(POOL.without(REFRACTION), spp, effort.takes))
    spps = (spp, effort.spp(128))
    return [
        same_picture(studio, POOL, POOL.by("path"), spps, effort.takes, BLOCKS, "right"),
        *(_alone(rights, wrongs, strategy) for strategy in ALONE),
        *_mixed(rights, wrongs),
    ]


def _alone(rights: Sequence[Image], wrongs: Sequence[Image], strategy: Strategy) -> Claim:
    """One strategy without weights, which is all wrong or all right."""
    ratio = factor(*strategy)
    return is_wrong(
        f"strategy (s, t) = {strategy} alone",
        POOL,
        Samples(_unweighted(wrongs, strategy), _unweighted(rights, strategy)),
        formula="η²" if ratio != 1 else "1",
        correction=REFRACTION,
        ratio=ratio,
    )


def _unweighted(images: Sequence[Image], strategy: Strategy) -> FloatArray:
    """(n,): mean luminance."""
    layers = (strategy_layers(image, "unweighted") for image in images)
    return np.array([float(luminance(layer[strategy]).mean()) for layer in layers])


def _mixed(rights: Sequence[Image], wrongs: Sequence[Image]) -> list[Claim]:
    """The whole picture, and that the blend is right in all of its parts."""
    right, wrong = (
        np.stack([luminance(image.color) for image in images]) for images in (rights, wrongs)
    )
    blend = np.stack([_blend(image) for image in rights])
    whole = BlendEvidence(*(takes.mean(axis=(1, 2)) for takes in (wrong, right, blend)))
    blocks = BlockEvidence(blocks_of(wrong, blend, *BLOCKS), 1.0)
    shot = POOL.without(REFRACTION)
    return [
        Claim(
            "all strategies, weighted, wrong",
            "wrong / right",
            shot,
            BLEND,
            whole.predicted,
            whole,
        ),
        Claim(
            name=f"all strategies, weighted, worst of {len(blocks.blocks.blocks)} blocks",
            quantity="wrong / predicted blend",
            shot=shot,
            formula="1",
            predicted=1.0,
            evidence=blocks,
        ),
    ]


def _pair(studio: Studio, effort: Effort) -> PicturePair:
    shot = replace(POOL, resolution=effort.size(320, 240))
    spp = effort.picture_spp(128)
    right, wrong = (studio.image(each, spp) for each in (shot, shot.without(REFRACTION)))
    colors = [np.asarray(image.color, dtype=np.float64) for image in (right, wrong)]
    return PicturePair(
        title="The blend",
        caption="Rough water, a large lamp, direct light. How wrong a pixel is depends on which "
        "strategies find its light well.",
        right=colors[0],
        wrong=colors[1],
        ratio=ratio_map(*colors),
        predicted_ratio=quotient(_blend(right), luminance(colors[0])),
    )


def _pyramid(studio: Studio, effort: Effort) -> Pyramid:
    """With light that is scattered under water, too."""
    shot = replace(
        POOL,
        resolution=effort.size(320, 240),
        max_depth=PYRAMID_EDGES - 1,
        strategy_images=PYRAMID_EDGES,
    )
    spp = effort.picture_spp(64)
    images = {
        "right": studio.image(shot, spp),
        "wrong": studio.image(shot.without(REFRACTION), spp),
    }
    layers = {
        (name, kind): {
            (s, t): layer
            for (s, t), layer in strategy_layers(image, kind).items()
            if s + t - 1 >= EDGES  # no shorter path brings light
        }
        for name, image in images.items()
        for kind in ("weighted", "unweighted")
    }
    return Pyramid(
        title="Every strategy by itself",
        caption="The same pool with two more bounces. Strategies (s, t) have s vertices on the "
        "light's side and t on the camera's. Unweighted, each is an estimate of all light that "
        "takes so many edges, and wrong code makes every one η² too bright that has crossed on the "
        "light's side; weighted, they add up to the picture.",
        weighted_right=layers["right", "weighted"],
        weighted_wrong=layers["wrong", "weighted"],
        unweighted_right=layers["right", "unweighted"],
        unweighted_wrong=layers["wrong", "unweighted"],
    )


def run(studio: Studio, effort: Effort) -> Outcome:
    claims = _claims(studio, effort)
    whole = next(claim for claim in claims if claim.formula == BLEND)
    return Outcome(
        headline=f"bdpt through rough water: {whole.predicted:.2f} ×, between 1 and η², as the "
        "weights have it",
        claims=tuple(claims),
        figures=(_pair(studio, effort), _pyramid(studio, effort)),
    )


CASE = Case(
    name="mis_blend",
    title="Multiple importance sampling mixes right and wrong",
    lesson="""
Bidirectional path tracing finds the same path in several ways, and weights them so that the better
one counts. With the correction missing, strategies whose light subpath has crossed the surface are
η² wrong and the others are right. The weights do not know; the picture becomes their mean,
wrong by an amount that changes from pixel to pixel, with the size of the lamp, the roughness, and
the number of light paths. That is why such errors are taken for noise, or for a matter of taste.

The weights of one right render predict that picture.
""",
    run=run,
)
