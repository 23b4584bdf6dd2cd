"""One level interface: closed forms."""

from __future__ import annotations

from math import cos, pi, radians

import numpy as np

from etendue.validation.case import Case, Outcome
from etendue.validation.cases.crossings import (
    CROSSINGS,
    ETAS,
    FORMULAS,
    INTO_WATER,
    REFRACTION,
    WATER,
    crossing_shot,
    plate,
)
from etendue.validation.claims import Claim
from etendue.validation.effort import Effort
from etendue.validation.pairs import Pair, measure
from etendue.validation.pictures import picture_pair
from etendue.validation.plots import measured_series
from etendue.validation.predictions import (
    crossing_ratio,
    floor_irradiance,
    floor_irradiance_under_lamp,
)
from etendue.validation.results import Plot, Series
from etendue.validation.shots import Shot, Studio
from etendue.validation.strategies import blend_claim, shares_of

REFLECTANCE = 0.5
#: Of the pool's lights: illuminance and zenith angle of the suns; intensity of the lamp.
SUNS = {"sun": (3.0, 0.0), "oblique_sun": (3.4, 30.0)}
LAMP = 32.0
LAMP_HEIGHT, DEPTH = 2.5, 1.0
#: What the meter sees of the floor, metres; its camera is half a metre above it.
METER = (0.8, 0.6)
ANGLE = 20.0
SPP = {"light": 256, "bdpt": 64}

_METER_VALUES = {
    "/cameras/meter.horizontalAperture": METER[0] / 0.5 * 0.9,
    "/cameras/meter.verticalAperture": METER[1] / 0.5 * 0.9,
}


def _pool_shot(light: str, integrator: str) -> Shot:
    return Shot(
        stage="flat_pool.usda",
        camera="/cameras/meter",
        integrator=integrator,
        resolution=(8, 6),
        max_depth=2,  # the surface, the floor
        variants={"/Lights{light}": light, "/World{walls}": "black"},
        values=_METER_VALUES,
        strategy_images=3 if integrator == "bdpt" else 0,
    )


def _pool_radiance(light: str) -> float:
    """Mean over the meter's view, direct light alone."""
    if light in SUNS:
        illuminance, angle = SUNS[light]
        irradiance = floor_irradiance(illuminance, cos(radians(angle)), WATER)
    else:
        x, z = ((np.arange(200) + 0.5) / 200 - 0.5 for _ in range(2))
        radius = np.hypot(METER[0] * x[:, None], METER[1] * z[None, :])
        under_lamp = floor_irradiance_under_lamp(LAMP, LAMP_HEIGHT, DEPTH, WATER, radius)
        irradiance = float(under_lamp.mean())
    return REFLECTANCE / pi * irradiance


def _pool_claims(studio: Studio, effort: Effort) -> list[Claim]:
    claims = []
    for light in (*SUNS, "lamp"):
        for integrator in ("light", "bdpt"):
            shot = _pool_shot(light, integrator)
            name = f"pool, {light.replace('_', ' ')}, {integrator}"
            spp = effort.spp(SPP[integrator])
            pair = measure(studio, shot, REFRACTION, spp, effort.takes, name)
            found = pair.claims(_pool_radiance(light), "closed form", "η²", INTO_WATER)
            if integrator == "bdpt":
                found[1] = _blend(studio, effort, pair, spp)
            claims += found
    return claims


def _blend(studio: Studio, effort: Effort, pair: Pair, spp: int) -> Claim:
    """Camera paths find a lamp of finite size now and then, and are right."""
    shares = shares_of(studio, pair.shot, spp, effort.takes)
    return blend_claim(pair, shares, lambda s, _t: INTO_WATER if s >= 2 else 1.0)


def _sweep(studio: Studio, effort: Effort, crossing: str) -> tuple[list[Claim], Series]:
    """Over indices of refraction: claims, and the points that were measured."""
    claims: list[Claim] = []
    points = []
    for eta in ETAS:
        media = (1.0, eta) if crossing == "enter" else (eta, 1.0)
        for integrator in ("light", "bdpt"):
            shot = crossing_shot(crossing, integrator, eta=eta, angle=ANGLE)
            name = f"{CROSSINGS[crossing]}, η = {eta:g}, {integrator}"
            pair = measure(
                studio, shot, REFRACTION, effort.spp(SPP[integrator]), effort.takes, name
            )
            claims += pair.claims(
                plate(ANGLE, media[1] / media[0]),
                "closed form",
                FORMULAS[crossing],
                crossing_ratio(*media),
            )
            if integrator == "light":
                points.append((eta, pair.measured))
    return claims, measured_series(_label(crossing), points)


def _label(crossing: str) -> str:
    return f"{CROSSINGS[crossing]}: {FORMULAS[crossing]}"


def _curve(crossing: str) -> Series:
    etas = [float(eta) for eta in np.linspace(1, 2.6, 65)]
    ratios = (
        crossing_ratio(1, eta) if crossing == "enter" else crossing_ratio(eta, 1) for eta in etas
    )
    return Series(_label(crossing), tuple(etas), tuple(ratios))


def run(studio: Studio, effort: Effort) -> Outcome:
    claims = _pool_claims(studio, effort)
    points = []
    for crossing in FORMULAS:
        found, measured = _sweep(studio, effort, crossing)
        claims += found
        points.append(measured)
    plot = Plot(
        title="Brightness error of light tracing across one interface",
        caption="Particles scaled like radiance (Veach 1997, 5.2). Most intervals are smaller than "
        "the points.",
        x_label="index of refraction η",
        y_label="wrong / right",
        predicted=tuple(_curve(crossing) for crossing in FORMULAS),
        measured=tuple(points),
        log_y=True,
    )
    pool = Shot(
        stage="flat_pool.usda",
        camera="/cameras/underwater",
        integrator="bdpt",
        resolution=effort.size(640, 480),
    )
    pair = picture_pair(
        studio,
        pool,
        REFRACTION,
        effort.picture_spp(16),
        "The still pool from under water",
        "Every light path that reaches the floor has entered the water once: the whole pool is "
        "1.777 × too bright, evenly. Nothing in the picture looks wrong by itself.",
    )
    return Outcome(
        headline="the floor under still water is η² = 1.777 × too bright; light that leaves "
        "glass η² too dark",
        claims=tuple(claims),
        figures=(plot, pair),
    )


CASE = Case(
    name="flat_water",
    title="Flat water: one crossing, one η²",
    lesson="""
Radiance is not constant across a refracting surface: it grows by the squared index of refraction
as its cone narrows, L / η² stays. A path traced from the camera must be scaled so. A path traced
from the light carries power, which only the Fresnel reflectance divides: it must not be scaled.
Code that shares one BSDF between both directions and leaves the scaling in makes everything that
light paths bring across the surface once η² times too bright, or too dark where they come out of
the dense side.

The floor under still water has a closed form: E cos θ T(θ) under a sun at zenith angle θ, at any
depth. The corrected renders are held against it, and the wrong ones against the right ones.
""",
    run=run,
)
