"""The same factor at rough surfaces."""

from __future__ import annotations

from dataclasses import replace

from etendue.arrays import FloatArray
from etendue.validation.case import Case, Outcome
from etendue.validation.cases.crossings import CROSSINGS, FORMULAS, REFRACTION, WATER, crossing_shot
from etendue.validation.claims import Claim
from etendue.validation.effort import Effort
from etendue.validation.errors import seen_by_camera
from etendue.validation.pairs import measure
from etendue.validation.plots import measured_series
from etendue.validation.predictions import crossing_ratio
from etendue.validation.results import Plot, Series
from etendue.validation.shots import Studio
from etendue.validation.strategies import blend_claim, shares_of

ANGLE = 20.0
#: Degrees across: path tracing then finds it through a nearly smooth surface, too.
SUN = 20.0
QUICK, FULL = (0.1, 0.3, 0.6), (0.05, 0.1, 0.2, 0.3, 0.45, 0.6, 0.8)


def _or_the_camera(claims: list[Claim], ratio: float) -> list[Claim]:
    """Path tracing may be what is wrong, which changes nothing in light paths with each other."""
    against_path, alone = claims
    seen = seen_by_camera(ratio)
    unmoved = dict.fromkeys(seen, alone.predicted)
    return [
        replace(against_path, under={**against_path.under, **seen}),
        replace(alone, under={**alone.under, **unmoved}),
    ]


def _by_bdpt(
    studio: Studio,
    effort: Effort,
    crossing: str,
    roughness: float,
    name: str,
    path: FloatArray,
    ratio: float,
) -> list[Claim]:
    shot = crossing_shot(
        crossing,
        "bdpt",
        eta=WATER,
        angle=ANGLE,
        roughness=roughness,
        sun_size=SUN,
        strategy_images=3,
    )
    spp = effort.spp(64)
    pair = measure(studio, shot, REFRACTION, spp, effort.takes, f"{name}, bdpt")
    shares = shares_of(studio, shot, spp, effort.takes)
    right = pair.claims(path, "path", "", ratio)[0]
    # Light subpaths of one vertex, the sun's own, have crossed nothing.
    blend = blend_claim(pair, shares, lambda s, _t: ratio if s >= 2 else 1.0)
    return [replace(right, under={}), blend]


def run(studio: Studio, effort: Effort) -> Outcome:
    claims: list[Claim] = []
    measured, curves = [], []
    roughnesses = effort.pick(QUICK, FULL)
    for crossing, formula in FORMULAS.items():
        ratio = crossing_ratio(1, WATER) if crossing == "enter" else crossing_ratio(WATER, 1)
        label = f"{CROSSINGS[crossing]}: {formula}"
        points = []
        for roughness in roughnesses:
            shot = crossing_shot(
                crossing, "light", eta=WATER, angle=ANGLE, roughness=roughness, sun_size=SUN
            )
            name = f"{CROSSINGS[crossing]}, roughness {roughness:g}"
            path = studio.means(shot.by("path"), effort.spp(512), effort.takes)
            pair = measure(
                studio, shot, REFRACTION, effort.spp(256), effort.takes, f"{name}, light"
            )
            found = pair.claims(path, "path", formula, ratio)
            claims += _or_the_camera(found, ratio)
            claims += _by_bdpt(studio, effort, crossing, roughness, name, path, ratio)
            points.append((roughness, pair.measured))
        measured.append(measured_series(label, points))
        curves.append(Series(label, (0.0, 1.0), (ratio, ratio)))
    plot = Plot(
        title="The error does not depend on roughness",
        caption="Light tracing through one rough surface of index 1.333.",
        x_label="roughness",
        y_label="wrong / right",
        predicted=tuple(curves),
        measured=tuple(measured),
    )
    return Outcome(
        headline="rough surfaces: the same η² at every roughness; bdpt shows part of it",
        claims=tuple(claims),
        figures=(plot,),
    )


CASE = Case(
    name="rough_water",
    title="Rough surfaces: the same factor",
    lesson="""
A rough dielectric spreads the refracted light, but the squared index is still there: fs(ωi→ωo) /
ηo² = fs(ωo→ωi) / ηi² for every physical BSDF, whatever its microfacets. The wrong ratio is η² at
every roughness, and only light paths show it.

A rough surface can be joined to lamps and cameras, so strategies with the surface on the light
side and strategies with it on the camera side find the same paths. Wrong code now gives them
different brightness, and bidirectional path tracing shows their weighted mean. The table predicts
that mean from the weights of a right render.
""",
    run=run,
)
