"""The wavy pool: the error in a caustic, and a view that does not show it."""

from __future__ import annotations

from dataclasses import replace

from etendue.validation.case import Case, Outcome
from etendue.validation.cases.crossings import INTO_WATER, REFRACTION
from etendue.validation.claims import Claim
from etendue.validation.effort import Effort
from etendue.validation.pairs import measure, same_picture, wrong_all_over
from etendue.validation.pictures import picture_pair
from etendue.validation.shots import Shot, Studio
from etendue.validation.strategies import blend_claim, shares_of

BLOCKS = (3, 4)
#: Metres: large enough for a path from the camera to find the lamp through two crossings.
LARGE_LAMP = {"/Lights/Lamp.inputs:radius": 1.0}

UNDERWATER = Shot(
    stage="caustic_pool.usda",
    camera="/cameras/underwater",
    integrator="light",
    resolution=(32, 24),
)
ABOVE = Shot(
    stage="caustic_pool.usda",
    camera="/cameras/above",
    integrator="bdpt",
    resolution=(32, 24),
    max_depth=3,  # water, floor, water
    values=LARGE_LAMP,
)


def _underwater(studio: Studio, effort: Effort) -> list[Claim]:
    spp = effort.spp(64)
    bdpt = UNDERWATER.by("bdpt")
    lit_widely = replace(bdpt, values=LARGE_LAMP)
    return [
        wrong_all_over(
            studio, UNDERWATER, REFRACTION, spp, effort.takes, BLOCKS, "light", "η²", INTO_WATER
        ),
        same_picture(
            studio, UNDERWATER, bdpt, (spp, effort.spp(32)), effort.takes, BLOCKS, "under water"
        ),
        same_picture(
            studio,
            lit_widely,
            lit_widely.by("path"),
            (effort.spp(16), effort.spp(128)),
            effort.takes,
            BLOCKS,
            "under water, large lamp",
        ),
        _direct_light(studio, effort),
    ]


def _direct_light(studio: Studio, effort: Effort) -> Claim:
    """Of lamp, water, floor, eye the weights tell what wrong light paths make."""
    shot = replace(UNDERWATER, integrator="bdpt", max_depth=2, strategy_images=3)
    spp = effort.spp(16)
    pair = measure(studio, shot, REFRACTION, spp, effort.takes, "bdpt, direct light")
    shares = shares_of(studio, shot, spp, effort.takes)
    return blend_claim(pair, shares, lambda s, _t: INTO_WATER if s >= 2 else 1.0)


def run(studio: Studio, effort: Effort) -> Outcome:
    claims = _underwater(studio, effort)
    spp = effort.spp(16)
    claims.append(
        wrong_all_over(
            studio, ABOVE, REFRACTION, spp, effort.takes, BLOCKS, "from above, bdpt", "1", 1.0
        )
    )
    below = picture_pair(
        studio,
        replace(UNDERWATER, integrator="bdpt", resolution=effort.size(640, 480)),
        REFRACTION,
        effort.picture_spp(8),
        "From under water",
        "The caustic is 1.777 × too bright wherever light paths carry it, which is nearly "
        "everywhere. By eye it is a brighter lamp; only a measurement tells.",
    )
    above = picture_pair(
        studio,
        replace(ABOVE, resolution=effort.size(640, 480), light_paths=0.25),
        REFRACTION,
        effort.picture_spp(48),
        "The same pool from above, lamp enlarged",
        "Floor and eye cannot be joined through the surface, so every strategy that reaches the "
        "floor is a camera path that finds the lamp by chance, and is right.",
    )
    return Outcome(
        headline="the pool's caustic is 1.777 × too bright from under water, and right from above",
        claims=tuple(claims),
        figures=(below, above),
    )


CASE = Case(
    name="caustic_pool",
    title="The caustic pool: where the error shows, and where it cannot",
    lesson="""
Light from the small lamp crosses the wavy surface once and is gathered into a network on the floor.
Every light path that ends under water is η² too bright in wrong code, whatever happened to it in
between: what counts is the medium where it began and the one where it ends.

From above the same error is invisible in direct light. The eye sees the floor through the surface,
a light path on the floor cannot be joined to it, and only camera paths bring the picture. Light
that has been scattered twice under water can be joined again, and carries the error into that view,
too: the check here stops at three bounces, before that.
""",
    run=run,
)
