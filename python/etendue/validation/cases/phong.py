"""An empirical model that is not symmetric."""

from __future__ import annotations

from etendue.validation.case import Case, Outcome
from etendue.validation.cases.tilted_facet import (
    direction,
    facet_shot,
    phong_radiance,
    spread,
)
from etendue.validation.claims import Claim
from etendue.validation.effort import Effort
from etendue.validation.pairs import measure
from etendue.validation.pictures import picture_pair
from etendue.validation.plots import measured_series
from etendue.validation.predictions import phong_ratio
from etendue.validation.results import Plot, Series
from etendue.validation.shots import Shot, Studio

CORRECTION = "phong"
NORMAL = (0.0, 1.0, 0.0)
SUN = -40.0
RANGE = (0.0, 60.0)
FORMULAS = {"classic": "|ωi·N| / |ωo·N|", "modified": "1"}


def _ratio(form: str, view: float) -> float:
    return phong_ratio(NORMAL, direction(SUN), direction(view)) if form == "classic" else 1.0


def _sweep(studio: Studio, effort: Effort, form: str) -> tuple[list[Claim], Series, Series]:
    """Claims, the predicted curve, the measured points."""
    claims: list[Claim] = []
    points = []
    for view in spread(*RANGE, effort.pick(5, 13)):
        shot = facet_shot("light", form, 0.0, SUN, view)
        name = f"{form}, view {view:g}°"
        pair = measure(studio, shot, CORRECTION, effort.spp(512), effort.takes, name)
        truth = phong_radiance(form, SUN, view)
        claims += pair.claims(truth, "closed form", FORMULAS[form], _ratio(form, view))
        points.append((view, pair.measured))
    fine = spread(*RANGE, 61)
    curve = Series(form, tuple(fine), tuple(_ratio(form, view) for view in fine))
    return claims, curve, measured_series(form, points)


def run(studio: Studio, effort: Effort) -> Outcome:
    claims: list[Claim] = []
    curves, measured = [], []
    for form in FORMULAS:
        found, curve, points = _sweep(studio, effort, form)
        claims += found
        curves.append(curve)
        measured.append(points)
    plot = Plot(
        title=f"Phong's highlight, sun at {-SUN:g}° from the normal",
        caption="Light tracing that scatters particles as if they were radiance.",
        x_label="angle of the camera from the normal, degrees",
        y_label="wrong / right",
        predicted=tuple(curves),
        measured=tuple(measured),
    )
    pair = picture_pair(
        studio,
        Shot(
            stage="phong.usda",
            camera="/cameras/main",
            integrator="light",
            resolution=effort.size(640, 480),
            light_paths=8.0,
        ),
        CORRECTION,
        effort.picture_spp(8),
        "Modified on the left, classic on the right",
        "Without the adjoint the classic highlight is off by the cosine of the light over that of "
        "the view. The modified form is symmetric and stays.",
        full_scale=4.0,
    )
    return Outcome(
        headline="Phong: the classic form is off by |ωi·N| / |ωo·N|, the modified one is right",
        claims=tuple(claims),
        figures=(plot, pair),
    )


CASE = Case(
    name="phong",
    title="Phong: a model that knows which way light flows",
    lesson="""
Phong's classic highlight divides by the cosine of the direction light comes from. That is not
symmetric: a light path, which knows where light comes from and samples where it goes, must use the
adjoint, fs with its arguments exchanged. Code that calls the same routine for both divides by the
wrong cosine. The modified form has no cosine, is symmetric, and shows no error.
""",
    run=run,
)
