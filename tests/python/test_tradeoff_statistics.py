"""What `etendue tradeoff` concludes from errors, on made-up renders of which the truth is known."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from pxr import Gf, UsdRender

import etendue
from etendue.arrays import FloatArray, Pixels
from etendue.comparison.distance import relative_squared_error
from etendue.stage import Stage
from etendue.tradeoff import tradeoff
from etendue.tradeoff.candidates import CANDIDATES
from etendue.tradeoff.fit import FALSE_ALARM, Curve, Floor, curve, floor, positive_mean, slope
from etendue.tradeoff.front import BUDGETS, choose, expected, front
from etendue.tradeoff.measurement import ladder, measured
from etendue.tradeoff.reference import Reference
from etendue.tradeoff.rendering import Snapshot
from etendue.tradeoff.results import CandidateResult
from etendue.validation.results import Estimate
from support.made_up_renders import MadeUp, Way, made_up_result, made_up_stage, parts, samples
from support.stage_builder import StageBuilder
from support.validation_results import picture

SEEDS = 6
TIMES = np.array([1.0, 2.0, 4.0, 8.0, 16.0])
BY_NAME = {candidate.name: candidate for candidate in CANDIDATES}


def estimate(value: float, arm: float = 0.0) -> Estimate:
    return Estimate(value, value - arm, value + arm, 0.95)


# ------------------------------------------------------------------------------------ the floor


def floor_of(
    random: np.random.Generator, noise: float, missing: float = 0.0
) -> tuple[Floor, float]:
    """As tradeoff() finds it, and as it is: of six renders of 16 passes, a reference of 64."""
    truth = picture()
    long = parts(random, truth, noise, 64)
    against = _reference(long.color, long.variance)
    found = truth.copy()
    found[:, :16] *= 1 - missing
    takes = [[Snapshot(16, 1.0, samples(random, found, noise, 16))] for _ in range(SEEDS)]
    result = measured(BY_NAME["bdpt"], takes, against).result
    # What the weights of the test make of the truth.
    relative = relative_squared_error(found, truth) * _impartial(truth)
    return Floor(result.floor, result.floor_p_value), float(relative.mean())


def _reference(color: Pixels, variance: Pixels) -> Reference:
    right = np.asarray(color, dtype=np.float64)
    noise = relative_squared_error(right + np.sqrt(variance), right)
    return Reference(right, noise, "made up")


def _impartial(truth: FloatArray) -> FloatArray:
    return Reference(truth, None, "the truth").impartial


def test_floor_where_there_is_none() -> None:
    """False alarms over 1,000 seeds, of noise with a long tail: at most as many as the test says.
    If it is right, this one fails with a probability of 0.1 %."""
    p_values = np.array(
        [floor_of(np.random.default_rng(seed), 2.0)[0].p_value for seed in range(1000)]
    )
    assert np.count_nonzero(p_values < FALSE_ALARM) <= 5
    assert np.count_nonzero(p_values < 0.05) <= 73
    # It is a test, too: small p-values do occur.
    assert np.count_nonzero(p_values < 0.3) >= 100


def test_floor_where_there_is_one() -> None:
    """A tenth of the light is missing in one half: it is always seen, and within the interval."""
    found = [floor_of(np.random.default_rng(seed), 0.5, 0.1) for seed in range(100)]
    assert all(one.resolved for one, _ in found)
    inside = sum(one.estimate.low <= truth <= one.estimate.high for one, truth in found)
    assert inside >= 90
    values = np.array([one.estimate.value / truth for one, truth in found])
    assert values.mean() == pytest.approx(1, abs=3 * values.std() / 10)


def test_a_bright_speck_is_no_floor() -> None:
    """All renders have the same one: it is real, but one place does not make a floor."""
    shared = np.random.default_rng(1).normal(0, 1e-4, (24, 32))
    shared[3, 5] = 50.0
    found = floor(shared)
    assert not found.resolved
    assert found.estimate.value > 0


def test_picture_of_one_tile_tells_nothing() -> None:
    found = floor(np.full((3, 3), 0.1))
    assert math.isnan(found.p_value)
    assert not found.resolved
    assert math.isinf(found.estimate.high)


# ------------------------------------------------------------------------------------ the line


def noisy(random: np.random.Generator, a: float, b: float = 0.0) -> FloatArray:
    """(n, rungs): errors whose mean is a / t + b, known to 5 %."""
    luck = random.normal(1, 0.05, (SEEDS, TIMES.size))
    return np.asarray((a / TIMES + b) * luck, dtype=np.float64)


def times() -> FloatArray:
    return np.tile(TIMES, (SEEDS, 1))


def test_slope_of_noise_is_minus_one() -> None:
    """The interval holds -1 in 95 % of 200 cases; in less than 180 of them once in 1,000 times."""
    held = 0
    for seed in range(200):
        found = slope(noisy(np.random.default_rng(seed), 0.3), times())
        held += found.low <= -1 <= found.high
        assert found.value == pytest.approx(-1, abs=0.1)
    assert held >= 180


def test_slope_bends_at_a_floor() -> None:
    found = slope(noisy(np.random.default_rng(1), 0.3, 0.1), times())
    assert found.low > -0.9


def test_curve_of_noise_and_floor() -> None:
    errors = noisy(np.random.default_rng(2), 0.3, 0.1)
    seen = Floor(estimate(0.1, 0.01), 1e-9)
    found = curve(errors, times(), seen)
    assert found.floor == 0.1
    assert found.noise.low < 0.3 < found.noise.high
    assert found.at(3.0) == pytest.approx(0.2, rel=0.05)
    # What is not resolved is not drawn.
    unseen = curve(noisy(np.random.default_rng(2), 0.3), times(), Floor(estimate(0.01, 0.02), 0.2))
    assert unseen.floor == 0
    assert unseen.at(3.0) == pytest.approx(0.1, rel=0.05)


def test_mean_of_one_has_no_interval() -> None:
    assert positive_mean(np.array([0.1])).high == math.inf
    assert positive_mean(np.array([0.1, -0.3])).high == math.inf


def test_ladder() -> None:
    assert ladder(100) == (1, 3, 6, 12, 25, 50, 100)
    assert ladder(4) == (1, 2, 4)
    assert ladder(1) == (1,)


# ------------------------------------------------------------------------------------ all of it


def test_candidates_are_told_apart() -> None:
    ways = {
        "path": Way(noise=0.5, pass_seconds=0.02),
        "light": Way(noise=1.0, pass_seconds=0.01),
        "bdpt": Way(noise=0.5, pass_seconds=0.01),
        "bdpt-depth-4": Way(noise=0.5, pass_seconds=0.001, missing=0.1),
    }
    found = made_up_result(ways, only=list(ways))
    assert [one.name for one in found.candidates] == list(ways)
    assert [one.verdict for one in found.candidates] == ["converges"] * 3 + ["floor"]
    for name, relative in (("path", 0.5), ("light", 0.25), ("bdpt", 1.0)):
        one, way = found[name], ways[name]
        # Of 768 squared errors and six renders the mean is known to 2 %: three times that, and of
        # a quotient.
        assert one.curve.noise.value == pytest.approx(way.noise**2 * way.pass_seconds, rel=0.065)
        assert one.relative_efficiency.value == pytest.approx(relative, rel=0.09)
        last = one.rungs[-1]
        assert one.efficiency.value == pytest.approx(1 / (last.rel_mse.value * last.seconds))
        assert one.slope.low < -1 < one.slope.high
        assert one.pooled.rel_mse.value == pytest.approx(last.rel_mse.value / SEEDS, rel=0.2)
        assert one.brightness.low < 1 < one.brightness.high
    short_of = found["bdpt-depth-4"]
    assert short_of.floor.value == pytest.approx(0.1**2 / 2, rel=0.2)
    assert short_of.slope.low > -1
    assert short_of.brightness.value == pytest.approx(0.95, abs=0.01)
    assert np.nanmedian(short_of.ratio[:, :16]) == pytest.approx(0.9, abs=0.03)
    # The quick one first, the one that gets there later.
    assert [choice.best for choice in found.choices][:1] == ["bdpt-depth-4"]
    assert found.choices[-1].best == "bdpt"


def test_reference_noise_is_subtracted() -> None:
    """A reference as noisy as the candidate doubles the error seen, not that told."""
    ways = {"bdpt": Way(noise=0.5, pass_seconds=0.01)}
    random = np.random.default_rng(3)
    truth = picture()
    renderer = MadeUp(ways, truth)
    takes = [renderer.snapshots({}, (16,), seed) for seed in range(SEEDS)]
    long = parts(random, truth, 0.5, 16)
    against = _reference(long.color, long.variance)
    found = measured(BY_NAME["bdpt"], takes, against).result
    clean = measured(BY_NAME["bdpt"], takes, Reference(truth, None, "the truth")).result
    assert found.rungs[-1].rel_mse.value == pytest.approx(clean.rungs[-1].rel_mse.value, rel=0.15)
    assert against.rel_mse == pytest.approx(clean.rungs[-1].rel_mse.value, rel=0.15)


def test_the_same_seed_gives_the_same_figures() -> None:
    first, second = (made_up_result(only=["bdpt", "light"]) for _ in range(2))
    assert first["light"].rungs == second["light"].rungs
    assert first["light"].floor == second["light"].floor
    assert first["light"].rungs != first["bdpt"].rungs


# ------------------------------------------------------------------------------------ the front


def candidate(
    name: str, noise: float, floor: float = 0.0, hidden: float = 0.0, pass_seconds: float = 0.01
) -> CandidateResult:
    """Whose curve is known; `floor` is resolved unless it is 0."""
    found = made_up_result({name: Way(pass_seconds=pass_seconds)}, only=[name])[name]
    return replace(
        found,
        curve=Curve(estimate(noise, 0.1 * noise), floor),
        floor=estimate(floor, hidden),
        verdict="floor" if floor else "converges",
    )


def test_choices_change_with_time() -> None:
    quick, exact = candidate("bdpt-depth-4", 0.1, 0.01), candidate("bdpt", 0.4)
    both = (exact, quick)
    assert choose(both, 1.0) is not None
    best = {seconds: choose(both, seconds) for seconds in BUDGETS}
    assert [one.best for one in best.values() if one] == ["bdpt-depth-4"] * 4 + ["bdpt"] * 2
    assert all(one is not None and one.as_good == () for one in best.values())
    assert [span.best for span in front(both)] == ["bdpt-depth-4", "bdpt"]
    first, second = front(both)
    # 0.1 / t + 0.01 = 0.4 / t
    assert second.begin == first.end == pytest.approx(30, rel=1e-3)


def test_who_is_not_told_from_the_best_is_named() -> None:
    choice = choose((candidate("bdpt", 0.4), candidate("bdpt-balance", 0.42)), 1.0)
    assert choice is not None
    assert (choice.best, choice.as_good) == ("bdpt", ("bdpt-balance",))


def test_curve_is_not_misled_by_rungs_that_missed_rare_light() -> None:
    """One sample in 1,000 makes nearly all the error: the mean of the curves over 400 seeds is
    right to 8 %, where a standard error is 2.3 %."""
    noise = []
    for seed in range(400):
        random = np.random.default_rng(seed)
        # Sums over passes of the squared error of 64 pixels: a mean of rare bright squares.
        hits = random.poisson(64 * np.diff([0.0, *TIMES]) / 1000, (SEEDS, TIMES.size)).cumsum(
            axis=1
        )
        errors = (hits / (64 * TIMES / 1000) + 0.01) / TIMES
        noise.append(curve(errors, times(), Floor(estimate(0.0, 1.0), 0.5)).noise.value)
    assert np.mean(noise) == pytest.approx(1.01, abs=0.08)


def test_fireflies_are_not_chosen() -> None:
    bdpt, path = candidate("bdpt", 0.4), candidate("path", 0.1)
    choice = choose((bdpt, replace(path, outliers=0.4)), 1.0)
    alone = choose((replace(path, outliers=0.4),), 1.0)
    assert choice is not None
    assert alone is not None
    assert (choice.best, alone.best) == ("bdpt", "path")


def test_who_has_not_finished_a_pass_is_not_chosen() -> None:
    slow = candidate("bdpt", 0.1, pass_seconds=2.0)
    quick = candidate("light", 0.4)
    chosen = [choose((slow, quick), seconds) for seconds in (1.0, 3.0)]
    assert [choice.best for choice in chosen if choice] == ["light", "bdpt"]
    assert choose((slow,), 1.0) is None


def test_unseen_floors_are_feared_beyond_what_was_measured() -> None:
    """Only of ways to render that need not find all light."""
    light, bdpt = candidate("light", 0.3, hidden=0.01), candidate("bdpt", 0.4, hidden=0.01)
    assert expected(light, 600.0).value == pytest.approx(0.3 / 600 + 0.01)
    assert expected(bdpt, 600.0).value == pytest.approx(0.4 / 600)
    assert expected(light, 1.0).value == pytest.approx(0.3)
    short, long = (choose((light, bdpt), seconds) for seconds in (1.0, 600.0))
    assert short is not None
    assert long is not None
    assert (short.best, long.best) == ("light", "bdpt")
    assert (short.extrapolated, long.extrapolated) == (False, True)


def test_the_mean_of_all_renders_counts_as_measured() -> None:
    """As good as one that takes as long as all of them: up to there nothing is extrapolated."""
    found = candidate("light", 0.3, hidden=0.01)
    longest, together = found.rungs[-1].seconds, found.pooled.seconds
    assert together == pytest.approx(SEEDS * longest)
    for seconds, beyond in (
        (2 * longest, False),
        (0.99 * together, False),
        (1.01 * together, True),
    ):
        choice = choose((found,), seconds)
        assert choice is not None
        assert choice.extrapolated == beyond
        assert choice.rel_mse.value == pytest.approx(0.3 / seconds + (0.01 if beyond else 0))


@pytest.mark.parametrize(
    ("full", "looked_at"),
    [
        ((960, 720), (160, 120)),
        ((720, 960), (120, 160)),
        ((64, 48), (64, 48)),
        ((1, 16384), (1, 160)),
        ((16384, 1), (160, 1)),
    ],
)
def test_no_view_is_enlarged(full: tuple[int, int], looked_at: tuple[int, int]) -> None:
    """By default it is made smaller."""
    stage = StageBuilder().lit_quad().stage
    product = UsdRender.Product.Define(stage, "/Product")
    product.CreateResolutionAttr(Gf.Vec2i(*full))
    product.CreateCameraRel().SetTargets(["/Camera"])
    settings = UsdRender.Settings.Define(stage, "/Settings")
    settings.CreateProductsRel().SetTargets(["/Product"])
    stage.SetMetadata("renderSettingsPrimPath", "/Settings")
    asked: list[tuple[int, int]] = []

    def renderer(stage: Stage, camera: str | None, resolution: tuple[int, int]) -> MadeUp:
        del stage, camera
        asked.append(resolution)
        width, height = resolution
        return MadeUp({}, picture(height, width))

    found = tradeoff(stage, time=1.0, only=["bdpt"], renderer=renderer)
    assert found.full_resolution == full
    assert asked == [looked_at]


@pytest.mark.parametrize("time", [0.0, -1.0, math.nan, math.inf])
def test_time_must_be_a_time(time: float) -> None:
    with pytest.raises(etendue.SettingsError, match="positive number of seconds"):
        tradeoff(made_up_stage(), time=time)


def test_no_candidate_is_nothing_to_measure() -> None:
    with pytest.raises(etendue.SettingsError, match="no candidate is named"):
        tradeoff(made_up_stage(), only=[])


def test_black_picture_has_no_error() -> None:
    black = MadeUp({}, np.zeros((24, 32, 3)))
    with pytest.raises(etendue.SceneError, match="/Camera sees no light"):
        tradeoff(made_up_stage(), renderer=lambda *_: black)
