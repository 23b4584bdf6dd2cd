"""Planted errors of a renderer are found, and named."""

from __future__ import annotations

from collections.abc import Callable
from math import nan

import numpy as np
import pytest

from etendue.arrays import FloatArray
from etendue.image import Image
from etendue.validation import validate
from etendue.validation.cases.smooth_shading import PLANE, region_claims
from etendue.validation.diagnosis import diagnose
from etendue.validation.effort import QUICK
from etendue.validation.errors import CORRECTIONS, RADIANCE
from etendue.validation.predictions import crossing_ratio
from etendue.validation.results import Check, ValidationResult
from etendue.validation.shots import Renderer, Shot, Studio, render
from support.planted_errors import (
    Repainted,
    dropping,
    exchanging,
    honest,
    honest_run,
    ignoring,
    inverting,
)
from support.recorder import FACET

#: The cheapest case that shows what a correction does.
CASE_OF = {"refraction": "rough_water", "shading_normal": "facets", "phong": "phong"}


def failed(result: ValidationResult) -> list[Check]:
    return [check for check in result.checks if not check.passed]


@pytest.mark.parametrize("case", CASE_OF.values())
def test_honest_renderer_passes(case: str) -> None:
    """False alarms: 1e-5 a check, and these seeds are fixed."""
    result = honest_run(case)
    assert failed(result) == []
    assert result.passed
    assert result.diagnoses == ()
    assert all(check.explanations == () for check in result.checks)


@pytest.mark.parametrize("correction", CORRECTIONS)
@pytest.mark.parametrize(
    ("fault", "plant"),
    [
        ("missing", dropping),
        ("inverted", inverting),
        ("applied only where it is switched off", exchanging),
    ],
)
def test_planted_error_is_named(
    correction: str, fault: str, plant: Callable[[str], Renderer]
) -> None:
    result = validate([CASE_OF[correction]], renderer=plant(correction))
    assert not result.passed
    assert result.diagnoses == (f"{CORRECTIONS[correction]} is {fault}",)
    # The corrected renders are refused, and so is their ratio to the wrong ones.
    assert {check.quantity for check in failed(result)} >= {"wrong / right"}
    assert any(not check.corrections_off for check in failed(result))


def test_planted_error_is_named_beside_a_case_that_hides_it() -> None:
    """Two crossings hide all of it but one strategy's share, which is no power of the factor."""
    result = validate(["rough_water", "two_crossings"], renderer=dropping("refraction"))
    block = next(
        check for check in failed(result) if check.name == "thick rough block, bdpt, right"
    )
    assert block.measured.value == pytest.approx(1.19, abs=0.05)
    assert result.diagnoses == (f"{CORRECTIONS['refraction']} is missing",)


@pytest.mark.parametrize("correction", CORRECTIONS)
def test_switch_without_effect_fails(correction: str) -> None:
    """What is right stays right, and no error of the corrected renders is named."""
    result = validate([CASE_OF[correction]], renderer=ignoring(correction))
    assert not result.passed
    assert {check.quantity for check in failed(result)} == {"wrong / right"}
    fault = "applied even where it is switched off"
    assert result.diagnoses == (f"{CORRECTIONS[correction]} is {fault}",)


def test_two_crossings_hide_all_errors_but_one() -> None:
    """What is predicted is 1 but in the thick block, where strategies are joined within the glass
    and weigh enough to be seen."""
    result = honest_run("two_crossings")
    assert failed(result) == []
    (block,) = (check for check in result.checks if check.predicted != pytest.approx(1, abs=1e-6))
    assert block.name == "thick rough block, bdpt, wrong"
    assert block.predicted == pytest.approx(1.19, abs=0.05)
    assert block.measured.low > 1.05


@pytest.mark.parametrize(("power", "fault"), [(1, "missing"), (2, "inverted")])
def test_error_of_camera_paths_is_named(power: int, fault: str) -> None:
    """The reference of rough water is path tracing: here it gets the squared index wrong."""

    def renderer(shot: Shot, spp: int, seed: int) -> Image:
        image = honest(shot, spp, seed)
        if shot.integrator != "path":
            return image
        entering = shot.variants["/World{crossing}"] == "enter"
        ratio = crossing_ratio(1, 1.333) if entering else crossing_ratio(1.333, 1)
        return Repainted(image, np.asarray(image.color, dtype=np.float64) / ratio**power)

    result = validate(["rough_water"], renderer=renderer)
    assert not result.passed
    assert result.diagnoses == (f"{RADIANCE} is {fault}",)


def test_black_renderer_fails() -> None:
    def black(shot: Shot, spp: int, seed: int) -> Image:
        del spp
        image = render(shot, 1, seed)
        return Repainted(image, np.zeros(image.color.shape))

    for case in ("phong", "mis_blend"):
        result = validate([case], renderer=black)
        # Pictures are black; the strategies' own images are not.
        assert {check.name for check in result.checks if check.passed} <= {
            f"strategy (s, t) = ({s}, {t}) alone, wrong" for s, t in ((1, 3), (2, 2), (3, 1))
        }


@pytest.mark.parametrize(
    ("power", "faults"),
    [(0, []), (1, ["missing", "applied even where it is switched off"]), (2, ["inverted"])],
)
def test_error_that_varies_from_pixel_to_pixel_is_named(power: int, faults: list[str]) -> None:
    """Regions of many factors: what an inverted one makes of their means is not what it makes of
    one pixel."""
    random = np.random.default_rng(1)
    factor = np.concatenate([random.uniform(1.2, 4, 864), random.uniform(0.2, 0.8, 864)])
    factor = factor.reshape(36, 48)
    base = render(FACET, 1, 1)

    def renderer(shot: Shot, spp: int, seed: int) -> Image:
        del spp
        noise = np.random.default_rng(seed).normal(1, 0.01, factor.shape)
        picture: FloatArray = noise * (factor if shot.off else factor**power)
        return Repainted(base, np.repeat(picture[..., None], 3, axis=2))

    named = diagnose(region_claims(Studio(1, renderer), QUICK, PLANE, factor))
    # Whether it never is applied, or always, no ratio of the two tells.
    assert named == tuple(f"{CORRECTIONS['shading_normal']} is {fault}" for fault in faults)


def test_renderer_of_no_numbers_fails() -> None:
    def broken(shot: Shot, spp: int, seed: int) -> Image:
        image = honest(shot, spp, seed)
        color = np.asarray(image.color, dtype=np.float64)
        color[-1, -1] = nan
        return Repainted(image, color)

    result = validate(["facets"], renderer=broken)
    assert not any(check.passed for check in result.checks)
