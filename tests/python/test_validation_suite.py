"""etendue.validate() finds errors of a renderer, and names them."""

from __future__ import annotations

import functools
import sys
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from math import nan

import numpy as np
import pytest

import etendue
from etendue.arrays import FloatArray
from etendue.image import Image
from etendue.validation import case_names, validate
from etendue.validation.cases import CASES
from etendue.validation.cases.mis_blend import POOL
from etendue.validation.cases.smooth_shading import PLANE, region_claims
from etendue.validation.cases.tilted_facet import N_G, direction, facet_shot
from etendue.validation.claims import FALSE_ALARM
from etendue.validation.diagnosis import diagnose
from etendue.validation.effort import FULL, QUICK, Effort
from etendue.validation.errors import CORRECTIONS, RADIANCE
from etendue.validation.predictions import crossing_ratio, shading_normal_ratio
from etendue.validation.results import Check, ValidationResult
from etendue.validation.shading_maps import predicted_ratio_map
from etendue.validation.shots import Renderer, Shot, Studio, render, stages_folder
from etendue.validation.strategies import blended, strategy_layers
from support.planted_errors import (
    Repainted,
    dropping,
    exchanging,
    honest,
    ignoring,
    inverting,
)

#: The cheapest case that shows what a correction does.
CASE_OF = {"refraction": "rough_water", "shading_normal": "facets", "phong": "phong"}
FACET = facet_shot("light", "matte", 0.0, 0.0, 0.0)


@functools.cache
def honest_run(case: str, seed: int = 1) -> ValidationResult:
    return validate([case], seed=seed, renderer=honest)


def failed(result: ValidationResult) -> list[Check]:
    return [check for check in result.checks if not check.passed]


# ---------------------------------------------------------------------------------- planted errors


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


# ------------------------------------------------------------------------------------------ a suite


class Recorder:
    """Renders as little as can be, and remembers what was asked for. Pictures that are only looked
    at, not measured, it makes small."""

    def __init__(self) -> None:
        self.asked: list[tuple[Shot, int, int]] = []

    def __call__(self, shot: Shot, spp: int, seed: int) -> Image:
        self.asked.append((shot, spp, seed))
        looked_at = shot.resolution[0] >= 160 and not shot.aovs
        return render(replace(shot, resolution=(16, 12)) if looked_at else shot, 1, seed)


@pytest.fixture(scope="module")
def everything() -> tuple[ValidationResult, Recorder]:
    """All cases, of renders that show next to nothing."""
    recorder = Recorder()
    return validate(renderer=recorder), recorder


def test_every_case_runs(everything: tuple[ValidationResult, Recorder]) -> None:
    result, recorder = everything
    assert tuple(case.name for case in result.cases) == case_names()
    assert sum(case.renders for case in result.cases) == len(recorder.asked)
    assert all(case.paths >= case.renders > 0 for case in result.cases)
    assert all(case.lesson and case.headline and case.title for case in result.cases)
    for shot, spp, _ in recorder.asked:
        assert (stages_folder() / shot.stage).is_file()
        assert spp >= 1
    assert result.false_alarm_rate == pytest.approx(len(result.checks) * FALSE_ALARM, rel=0.01)


def test_names_of_checks_are_unique(everything: tuple[ValidationResult, Recorder]) -> None:
    for case in everything[0].cases:
        counted = Counter(check.name for check in case.checks)
        assert [name for name, count in counted.items() if count > 1] == []


def test_names_of_cases_are_unique() -> None:
    assert len(set(case_names())) == len(CASES)


def test_every_correction_is_shown_wrong(everything: tuple[ValidationResult, Recorder]) -> None:
    off = {name for check in everything[0].checks for name in check.corrections_off}
    assert off == set(CORRECTIONS)


def test_chosen_cases_run_in_the_suites_order() -> None:
    seen: list[tuple[str, int, int]] = []
    result = validate(
        ["phong", "facets", "phong"],
        renderer=Recorder(),
        progress=lambda name, done, total: seen.append((name, done, total)),
    )
    assert [case.name for case in result.cases] == ["facets", "phong"]
    assert seen == [("facets", 0, 2), ("phong", 1, 2)]


def test_same_seed_same_figures() -> None:
    def figures(result: ValidationResult) -> list[Check]:
        return list(result.checks)

    again = validate(["phong"], renderer=honest)
    assert figures(again) == figures(honest_run("phong"))
    assert again.cases[0].figures[0] == honest_run("phong").cases[0].figures[0]
    other = validate(["phong"], seed=2, renderer=honest)
    assert all(
        one.measured != two.measured
        for one, two in zip(figures(other), figures(again), strict=True)
    )


def test_unknown_names() -> None:
    with pytest.raises(etendue.SettingsError, match="unknown case 'puddle'; there are: flat_water"):
        validate(["phong", "puddle"], renderer=honest)
    with pytest.raises(
        etendue.SettingsError, match="unknown effort 'some'; there are: quick, full"
    ):
        validate(["phong"], effort="some", renderer=honest)


def test_missing_package_is_told_before_the_work(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "scipy.stats", None)
    recorder = Recorder()
    with pytest.raises(etendue.Error, match=r"pip install 'etendue\[report\]'"):
        validate(["phong"], renderer=recorder)
    assert recorder.asked == []


# ------------------------------------------------------------------------------------------- effort


def test_effort() -> None:
    assert (QUICK.spp(64), FULL.spp(64)) == (64, 64 * FULL.scale)
    assert Effort("tiny", 0.001, 2, full=False).spp(64) == 1
    assert (QUICK.size(640, 480), FULL.size(640, 480)) == ((240, 180), (640, 480))
    assert (QUICK.picture_spp(8), FULL.picture_spp(8)) == (8, 16)
    assert (QUICK.pick("a", "b"), FULL.pick("a", "b")) == ("a", "b")


def test_full_asks_for_more_samples() -> None:
    def most(effort: str) -> int:
        recorder = Recorder()
        validate(["phong"], effort=effort, renderer=recorder)
        return max(spp for _, spp, _ in recorder.asked)

    assert most("full") == FULL.scale * most("quick") > most("quick")


# ------------------------------------------------------------------------------------------- studio


@pytest.fixture
def recorder() -> Recorder:
    return Recorder()


def seeds(recorder: Recorder) -> list[int]:
    return [seed for _, _, seed in recorder.asked]


def test_takes_are_rendered_once(recorder: Recorder) -> None:
    studio = Studio(1, recorder)
    first = studio.takes(FACET, 2, 3)
    assert first.shape == (3, 4, 4)
    assert studio.takes(FACET, 2, 3) is first
    assert studio.means(FACET, 2, 3) == pytest.approx(first.mean(axis=(1, 2)))
    assert len(recorder.asked) == studio.renders == 3
    assert studio.paths > 0


def test_takes_are_independent(recorder: Recorder) -> None:
    """Of each other, of another name's, of the wrong picture's, of other samples' and seeds'."""
    studio = Studio(1, recorder)
    studio.takes(FACET, 2, 3)
    studio.takes(FACET, 2, 3, "others")
    studio.takes(FACET.without("phong"), 2, 3)
    studio.takes(FACET.by("path"), 2, 3)
    studio.takes(FACET, 4, 3)
    studio.image(FACET, 2)
    Studio(2, recorder).takes(FACET, 2, 3)
    assert len(set(seeds(recorder))) == len(recorder.asked) == 19


def test_pictures_of_a_pair_share_their_paths(recorder: Recorder) -> None:
    studio = Studio(1, recorder)
    studio.image(FACET, 2)
    studio.image(FACET.without("phong"), 2)
    studio.image(FACET, 2, take=1)
    first, second, other = seeds(recorder)
    assert first == second != other


def test_first_hits_are_the_same_points(recorder: Recorder) -> None:
    """Whatever the stage's values are, and with or without a correction."""
    studio = Studio(1, recorder)
    bent = replace(FACET, values={**FACET.values, "/World/Facet.normals": None})
    one, two = studio.first_hits(FACET), studio.first_hits(bent)
    studio.first_hits(FACET.without("phong"))
    assert seeds(recorder)[0] == seeds(recorder)[1]
    np.testing.assert_array_equal(one["depth"], two["depth"])


def test_what_a_shot_is_called() -> None:
    shot = Shot(
        stage="a.usda",
        camera="/c",
        integrator="light",
        resolution=(4, 4),
        variants={"/World{crossing}": "slab"},
        values={"/A/B.inputs:ior": 1.5, "/A.normals": ((0.0, 1.0, 0.0),) * 4, "/A.none": None},
    )
    assert shot.described == "a.usda (crossing=slab, B.ior=1.5, A.normals=(0, 1, 0), A.none=none)"
    assert replace(shot, variants={}, values={}).described == "a.usda"


def test_shots_that_differ() -> None:
    shot = replace(FACET, integrator="bdpt", strategy_images=3)
    assert shot.without("phong").off == ("phong",)
    assert shot.by("path").strategy_images == 0
    assert shot.by("light").strategy_images == 3


def test_corrections_reach_the_core() -> None:
    """A classic highlight, seen where the correction's factor is cos 40 / cos 0."""
    shot = facet_shot("light", "classic", 0.0, -40.0, 0.0)
    right, wrong = (render(each, 4, 7).color.mean() for each in (shot, shot.without("phong")))
    assert wrong / right == pytest.approx(np.cos(np.radians(40)), rel=1e-5)


def test_renderer_of_no_numbers_fails() -> None:
    def broken(shot: Shot, spp: int, seed: int) -> Image:
        image = honest(shot, spp, seed)
        color = np.asarray(image.color, dtype=np.float64)
        color[-1, -1] = nan
        return Repainted(image, color)

    result = validate(["facets"], renderer=broken)
    assert not any(check.passed for check in result.checks)


# --------------------------------------------------------------------------- maps and strategies


def test_map_of_true_normals_is_one() -> None:
    ratio = predicted_ratio_map(Studio(1), PLANE.shot, {}, PLANE.lamp, 1)
    assert np.isfinite(ratio).mean() > 0.5
    np.testing.assert_allclose(ratio[np.isfinite(ratio)], 1, atol=1e-12)


def test_map_of_one_facet() -> None:
    """All of it leans alike; the lamp and the camera are so far away that two angles tell."""
    sun, view, lean = 30.0, -20.0, 25.0
    eye, far = 1000 * direction(view), 1000 * direction(sun)
    shot = replace(
        facet_shot("light", "matte", lean, sun, view),
        values={
            "/World/Facet.normals": (tuple(direction(lean)),) * 4,
            "/cameras/arm.xformOp:rotateZ": -view,
            "/cameras/arm/main.projection": "perspective",
            "/cameras/arm/main.xformOp:translate": (0.0, 1000.0, 0.0),
            "/cameras/arm/main.clippingRange": (1.0, 2000.0),
            "/cameras/arm/main.focalLength": 50_000.0,
        },
    )
    flat = {"/World/Facet.normals": None}
    ratio = predicted_ratio_map(Studio(1), shot, flat, (far[0], far[1], far[2]), 2)
    expected = shading_normal_ratio(direction(lean), N_G, far / 1000, eye / 1000)
    assert expected == pytest.approx(0.654, abs=1e-3)
    np.testing.assert_allclose(ratio, expected, rtol=2e-3)


def test_strategies_add_up_to_the_picture() -> None:
    image = render(POOL, 1, 1)
    layers = strategy_layers(image, "weighted")
    assert set(layers) >= {(0, 4), (1, 3), (2, 2), (3, 1)}
    np.testing.assert_allclose(sum(layers.values()), image.color, rtol=1e-4, atol=1e-6)
    assert set(strategy_layers(image, "unweighted")) >= {(1, 3), (2, 2), (3, 1)}


def test_blended() -> None:
    takes = [{(1, 3): np.full((2, 2), 1.0), (2, 2): np.full((2, 2), scale)} for scale in (2.0, 3.0)]
    right, wrong = blended(takes, lambda s, _t: 10.0 if s >= 2 else 1.0)
    np.testing.assert_allclose(right, [3, 4])
    np.testing.assert_allclose(wrong, [21, 31])
