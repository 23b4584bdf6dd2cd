"""Shading normals on one facet: the factor as a curve."""

from __future__ import annotations

from collections.abc import Callable

from etendue.validation.case import Case, Outcome
from etendue.validation.cases.tilted_facet import (
    N_G,
    direction,
    facet_shot,
    matte_radiance,
    spread,
)
from etendue.validation.claims import Claim
from etendue.validation.effort import Effort
from etendue.validation.pairs import measure
from etendue.validation.plots import measured_series
from etendue.validation.predictions import shading_normal_ratio
from etendue.validation.results import Plot, Series
from etendue.validation.shots import Studio

CORRECTION = "shading_normal"
FORMULA = "|ωi·Ng| |ωo·Ns| / (|ωi·Ns| |ωo·Ng|)"
TILTS_QUICK, TILTS_FULL = (25.0,), (10.0, 25.0, 40.0)
RANGE = 45.0
FIXED_SUN, FIXED_VIEW = 35.0, 0.0

Angles = Callable[[float], tuple[float, float]]


def _ratio(tilt: float, sun: float, view: float) -> float:
    return shading_normal_ratio(direction(tilt), N_G, direction(sun), direction(view))


def _sweep(
    studio: Studio, effort: Effort, title: str, x_label: str, angles: Angles
) -> tuple[list[Claim], Plot]:
    """`angles` makes the sun's and the camera's of the one that varies."""
    claims: list[Claim] = []
    curves, measured = [], []
    for tilt in effort.pick(TILTS_QUICK, TILTS_FULL):
        label = f"normals lean {tilt:g}°"
        points = []
        for x in spread(-RANGE, RANGE, effort.pick(7, 13)):
            sun, view = angles(x)
            ratio = _ratio(tilt, sun, view)
            shot = facet_shot("light", "matte", tilt, sun, view)
            name = f"lean {tilt:g}°, sun {sun:g}°, view {view:g}°"
            pair = measure(studio, shot, CORRECTION, effort.spp(512), effort.takes, name)
            claims += pair.claims(matte_radiance(tilt, sun), "closed form", FORMULA, ratio)
            points.append((x, pair.measured))
        fine = spread(-RANGE, RANGE, 91)
        ratios = tuple(_ratio(tilt, *angles(x)) for x in fine)
        curves.append(Series(label, tuple(fine), ratios))
        measured.append(measured_series(label, points))
    plot = Plot(
        title=title,
        caption="Light tracing that takes the shading normal for the geometry. 0° is the facet's "
        "own normal; its shading normals lean towards positive angles.",
        x_label=x_label,
        y_label="wrong / right",
        predicted=tuple(curves),
        measured=tuple(measured),
    )
    return claims, plot


def run(studio: Studio, effort: Effort) -> Outcome:
    by_sun, sun_plot = _sweep(
        studio,
        effort,
        f"The error over the sun's angle, camera at {FIXED_VIEW:g}°",
        "angle of the sun, degrees",
        lambda x: (x, FIXED_VIEW),
    )
    by_view, view_plot = _sweep(
        studio,
        effort,
        f"The error over the camera's angle, sun at {FIXED_SUN:g}°",
        "angle of the camera, degrees",
        lambda x: (FIXED_SUN, x),
    )
    ratios = [claim.predicted for claim in (*by_sun, *by_view) if claim.quantity == "wrong / right"]
    return Outcome(
        headline=f"facets: {min(ratios):.2f} to {max(ratios):.2f} × with the angles of light and "
        "view",
        claims=(*by_sun, *by_view),
        figures=(sun_plot, view_plot),
    )


CASE = Case(
    name="facets",
    title="A facet with a leaning normal: the error is a known function of two angles",
    lesson="""
Shading with another normal than the geometry's is a change of the BSDF, and makes it asymmetric. A
camera path never notices: the cosine that it should divide by cancels. A light path carries power
per real area, so it needs the factor |ωi·Ns| |ωo·Ng| / (|ωi·Ng| |ωo·Ns|). Left out, the facet's
brightness depends on where it is seen from, though it is matte, and is wrong by a number that two
angles tell.

Issues 13, 385 and 526 of the pbrt-v4 renderer are cases of it: its light paths lost the factor that
pbrt-v3 had.
""",
    run=run,
)
