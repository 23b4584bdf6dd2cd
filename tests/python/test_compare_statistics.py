"""Confidence intervals of etendue.compare hold as often as they say."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import numpy.typing as npt
import pytest
from scipy import stats

from etendue.comparison.causes import likely_causes
from etendue.comparison.picture import Picture
from etendue.comparison.ratio import LEVEL, Ratio, ratio_from_tiles, ratio_from_variances
from etendue.comparison.region import brightest_region
from etendue.comparison.tiles import tile_numbers, tile_sums
from etendue.interval import interval_text
from etendue.luminance import luminance

FloatArray = npt.NDArray[np.float64]

SEEDS = 1000
#: Chance that an interval that holds at its rate fails a test, both tails together.
FALSE_ALARM = 1e-5
TRUTH = 1.777
SHAPE = (48, 64)
#: Passes of a render whose scatter makes the variance channel.
PASSES = 8


def binomial_bounds(rate: float) -> tuple[float, float]:
    """How many of SEEDS intervals may miss that miss at this rate."""
    missing = stats.binom(SEEDS, rate)
    return missing.ppf(FALSE_ALARM / 2), missing.isf(FALSE_ALARM / 2)


def picture() -> FloatArray:
    """A bright patch on a gradient."""
    luminance = np.broadcast_to(np.linspace(0.2, 1, SHAPE[1]), SHAPE).copy()
    luminance[12:24, 16:32] = np.linspace(4, 6, 16)
    return luminance


def renders(mean: FloatArray, random: np.random.Generator) -> tuple[FloatArray, FloatArray]:
    """Means of passes with skewed noise, 40 % of a pixel in each, and their variances."""
    passes = random.gamma(6.25, mean / 6.25, (PASSES, *mean.shape))
    variances: FloatArray = passes.var(axis=0, ddof=1) / PASSES
    return passes.mean(axis=0), variances


def by_variance(random: np.random.Generator) -> Ratio:
    (a, var_a), (b, var_b) = renders(picture(), random), renders(TRUTH * picture(), random)
    return ratio_from_variances(a.ravel(), b.ravel(), var_a.ravel(), var_b.ravel())


def by_tiles(random: np.random.Generator) -> Ratio:
    tiles = tile_numbers(*SHAPE)
    a, b = renders(picture(), random)[0], renders(TRUTH * picture(), random)[0]
    return ratio_from_tiles(tile_sums(a, tiles), tile_sums(b, tiles), a.size)


def in_brightest_by_variance(random: np.random.Generator) -> Ratio:
    """The region chosen from the same pictures, as compare() does without a reference; of which
    only B is noisy, so that its noise alone could favour it."""
    a, none = picture(), np.zeros(SHAPE)
    b, var_b = renders(TRUTH * a, random)
    region = brightest_region(a / a.mean() + b / b.mean())
    return ratio_from_variances(a[region], b[region], none[region], var_b[region])


def in_brightest_by_tiles(random: np.random.Generator) -> Ratio:
    """Tiles of which the region has only parts."""
    a, b = renders(picture(), random)[0], renders(TRUTH * picture(), random)[0]
    region = brightest_region(a / a.mean() + b / b.mean())
    _, tiles = np.unique(tile_numbers(*SHAPE)[region], return_inverse=True)
    return ratio_from_tiles(tile_sums(a[region], tiles), tile_sums(b[region], tiles), tiles.size)


def dark(random: np.random.Generator) -> Ratio:
    """Six standard errors from black, where a symmetric interval around the ratio would not do."""
    a, b = random.normal(6, 1), random.normal(TRUTH * 6, 0.1)
    one = np.array([1.0])
    return ratio_from_variances(np.array([a]), np.array([b]), one, one / 100)


@pytest.mark.parametrize(
    "measure", [by_variance, by_tiles, in_brightest_by_variance, in_brightest_by_tiles]
)
def test_intervals_hold_at_their_rate(measure: Callable[[np.random.Generator], Ratio]) -> None:
    misses = sum(TRUTH not in measure(random) for random in generators())
    fewest, most = binomial_bounds(1 - LEVEL)
    assert fewest <= misses <= most


def test_near_black_both_ends_hold() -> None:
    """Either end of the interval may miss half as often; a symmetric interval errs on one side."""
    found = [dark(random) for random in generators()]
    fewest, most = binomial_bounds((1 - LEVEL) / 2)
    assert fewest <= sum(one.low > TRUTH for one in found) <= most
    assert fewest <= sum(one.high < TRUTH for one in found) <= most


def test_variance_of_luminance_is_that_of_noise_common_to_all_channels() -> None:
    color = np.array([[[2.0, 1.0, 4.0]]])
    noisy = color * (1 + np.random.default_rng(0).normal(0, 0.1, (20000, 1, 1, 1)))
    shown = Picture("a.exr", (0, 0, 1, 1), color, noisy.var(axis=0))
    assert shown.luminance_variance == pytest.approx(luminance(noisy).var(axis=0), rel=1e-9)


def test_intervals_are_no_wider_than_they_must_be() -> None:
    """The mean of 3072 pixels of 40 % noise in 8 passes is known to so much."""
    a = picture()
    error = 0.4 / np.sqrt(PASSES) * np.sqrt((a**2).sum()) / a.sum()
    expected = stats.norm.ppf((1 + LEVEL) / 2) * TRUTH * np.sqrt(2) * error
    for measure in (by_variance, by_tiles):
        half = np.mean([(r.high - r.low) / 2 for r in map(measure, generators(100))])
        assert half == pytest.approx(expected, rel=0.1)


def generators(count: int = SEEDS) -> Iterator[np.random.Generator]:
    return (np.random.default_rng(seed) for seed in range(count))


def test_what_is_not_lit_has_no_ratio() -> None:
    black, one = np.zeros(4), np.ones(4)
    assert not ratio_from_variances(black, one, one, one).known
    assert not ratio_from_tiles(black, one, 4).known


# -------------------------------------------------------------------------------------- what to say


def ratio(low: float, high: float) -> Ratio:
    return Ratio((low + high) / 2, low, high, 100, "jackknife")


@pytest.mark.parametrize(
    ("low", "high", "named"),
    [
        (1.77, 1.79, ["one uncancelled η² = 1.777 (η = 1.333, water)"]),
        (0.56, 0.57, ["one uncancelled η⁻² = 0.5628 (η = 1.333, water)"]),
        (2.24, 2.26, ["one uncancelled η² = 2.25 (η = 1.5, glass)"]),
        (34.2, 34.4, ["two uncancelled η², η⁴ = 34.3 (η = 2.42, diamond)"]),
        (1.78, 1.79, []),
        (0.9, 2.0, []),
        (-np.inf, np.inf, []),
    ],
)
def test_causes(low: float, high: float, named: list[str]) -> None:
    assert list(likely_causes(ratio(low, high))) == named


def test_all_causes_that_fit_are_told() -> None:
    assert len(likely_causes(ratio(1.5, 2.5))) == 2


@pytest.mark.parametrize(
    ("low", "high", "told"),
    [(1.767, 1.787, "1.777 ± 0.010"), (1.5, 2.5, "2.00 ± 0.50"), (100, 160, "130 ± 30")],
)
def test_interval(low: float, high: float, told: str) -> None:
    assert interval_text(ratio(low, high)) == told
