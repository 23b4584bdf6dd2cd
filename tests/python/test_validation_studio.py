"""The studio of the validation suite: which renders it asks for, and what it makes of them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from etendue.validation.cases.mis_blend import POOL
from etendue.validation.cases.smooth_shading import PLANE
from etendue.validation.cases.tilted_facet import N_G, direction, facet_shot
from etendue.validation.predictions import shading_normal_ratio
from etendue.validation.shading_maps import predicted_ratio_map
from etendue.validation.shots import Shot, Studio, render
from etendue.validation.strategies import blended, strategy_layers
from support.recorder import FACET, Recorder


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
