"""In and out again: the factors cancel, mostly."""

from __future__ import annotations

from dataclasses import replace
from math import cos, radians

from etendue.validation.case import Case, Outcome
from etendue.validation.cases.crossings import REFRACTION, crossing_shot, plate
from etendue.validation.claims import Claim
from etendue.validation.effort import Effort
from etendue.validation.pairs import measure, wrong_all_over
from etendue.validation.pictures import picture_pair
from etendue.validation.predictions import crossings_ratio, fresnel_reflectance
from etendue.validation.shots import Shot, Studio
from etendue.validation.strategies import blend_claim, shares_of

ETAS = (1.333, 1.5, 2.42)
ANGLE = 20.0
GLASS = 1.5
#: Degrees across: finite, so that strategies may end at it.
SUN = 10.0
ROUGHNESS = 0.9
#: The slab's upper face two metres up, and so wide that no sun passes it by. Strategies that are
#: joined within the glass weigh the more the thicker it is: in the thin slab less than 1e-5.
UPPER = tuple((1.2 * x, 2.0, 1.2 * z) for x, z in ((-1, 1), (1, 1), (1, -1), (-1, -1)))

SPHERE = Shot(
    stage="glass_sphere.usda",
    camera="/cameras/main",
    integrator="light",
    resolution=(48, 36),
    crop=(0, 24, 48, 36),  # the floor, where the caustic is
)


def _slab(studio: Studio, effort: Effort, eta: float, integrator: str) -> list[Claim]:
    shot = crossing_shot("slab", integrator, eta=eta, angle=ANGLE)
    spp = effort.spp(256 if integrator == "light" else 64)
    name = f"slab, η = {eta:g}, {integrator}"
    pair = measure(studio, shot, REFRACTION, spp, effort.takes, name)
    # Both surfaces are met at angles that belong to each other and reflect alike.
    transmitted = 1 - fresnel_reflectance(cos(radians(ANGLE)), eta)
    truth = plate(ANGLE, eta) * transmitted
    return pair.claims(truth, "closed form", "η² η⁻² = 1", crossings_ratio([1, eta, 1]))


def _rough_block(studio: Studio, effort: Effort) -> list[Claim]:
    """Strategies that are joined within the glass have crossed once on each side."""
    shot = crossing_shot(
        "slab",
        "bdpt",
        eta=GLASS,
        roughness=ROUGHNESS,
        sun_size=SUN,
        strategy_images=4,
    )
    shot = replace(shot, values={**shot.values, "/World/Upper.points": UPPER})
    spp = effort.spp(64)
    pair = measure(studio, shot, REFRACTION, spp, effort.takes, "thick rough block, bdpt")
    shares = shares_of(studio, shot, spp, effort.takes)
    path = studio.means(shot.by("path"), effort.spp(512), effort.takes)
    # What leaving the correction out makes of it is no power of a single factor.
    right = replace(pair.claims(path, "path", "", 1.0)[0], under={})
    blend = blend_claim(pair, shares, lambda s, t: GLASS**2 if (s, t) == (2, 3) else 1.0)
    return [right, blend]


def run(studio: Studio, effort: Effort) -> Outcome:
    claims: list[Claim] = []
    for eta in ETAS:
        for integrator in ("light", "bdpt"):
            claims += _slab(studio, effort, eta, integrator)
    claims += _rough_block(studio, effort)
    spp = effort.spp(512)
    claims.append(
        wrong_all_over(
            studio, SPHERE, REFRACTION, spp, effort.takes, (1, 4), "glass sphere, light", "1", 1.0
        )
    )
    pair = picture_pair(
        studio,
        replace(SPHERE, integrator="bdpt", resolution=effort.size(640, 480), crop=None),
        REFRACTION,
        effort.picture_spp(16),
        "The glass sphere, right and wrong: no difference",
        "Whatever reaches the floor through the ball has gone in and out. A renderer tested with "
        "glass balls alone passes with the factor missing.",
    )
    return Outcome(
        headline="through slab and glass ball wrong code looks right: the factors cancel",
        claims=tuple(claims),
        figures=(pair,),
    )


CASE = Case(
    name="two_crossings",
    title="Two crossings: the error that hides",
    lesson="""
Going in multiplies a wrongly scaled particle by η², coming out divides it by the same number.
Behind a window, a slab or a glass ball nothing is left of the error, which is why it survives in
renderers: the usual test scenes cannot show it. What counts is the medium where the light path
ends against the one where it began.

The exception is a thick, rough block under bidirectional path tracing. There a light path that has
entered the glass can be joined, within it, to a camera path that has entered from the other side:
strategy (s, t) = (2, 3) has one crossing on the light side, and is η² wrong. The thicker the block,
the more that strategy counts; in a thin slab its weight is next to nothing.
""",
    run=run,
)
