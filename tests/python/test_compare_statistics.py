"""Confidence intervals of etendue.compare hold as often as they say."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import numpy.typing as npt
import pytest
from scipy import ndimage, stats

from etendue.comparison.causes import fitting_causes, likely_cause
from etendue.comparison.correlation import noise_correlation
from etendue.comparison.picture import Picture
from etendue.comparison.ratio import LEVEL, Ratio, ratio_from_tiles, ratio_from_variances
from etendue.comparison.region import brightest_region
from etendue.comparison.sentence import sentence
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


def splatted(random: np.random.Generator) -> tuple[FloatArray, ...]:
    """A, B, their variances: light paths splat through a Gaussian of half a pixel."""
    found = []
    for factor in (1.0, TRUTH):
        passes = random.gamma(6.25, factor * picture() / 6.25, (PASSES, *SHAPE))
        passes = ndimage.gaussian_filter(passes, (0, 0.5, 0.5), mode="wrap")
        found.append((passes.mean(axis=0), passes.var(axis=0, ddof=1) / PASSES))
    (a, var_a), (b, var_b) = found
    return a, b, var_a, var_b


def splatted_by_variance(random: np.random.Generator) -> Ratio:
    planes = splatted(random)
    a, b, var_a, var_b = (plane.ravel() for plane in planes)
    return ratio_from_variances(a, b, var_a, var_b, noise_correlation(*planes))


def splatted_by_tiles(random: np.random.Generator) -> Ratio:
    tiles = tile_numbers(*SHAPE)
    a, b, *_ = splatted(random)
    return ratio_from_tiles(tile_sums(a, tiles), tile_sums(b, tiles), a.size)


def few_by_variance(random: np.random.Generator) -> Ratio:
    """Ten pixels, of which one makes most of the sum and of its noise."""
    mean = np.array([10.0] + 9 * [1.0])
    (a, var_a), (b, var_b) = renders_of_normal_noise(mean, random), (TRUTH * mean, 0 * mean)
    return ratio_from_variances(a, b, var_a, var_b)


def renders_of_normal_noise(
    mean: FloatArray, random: np.random.Generator
) -> tuple[FloatArray, FloatArray]:
    passes = random.normal(mean, 0.1 * mean, (PASSES, *mean.shape))
    return passes.mean(axis=0), passes.var(axis=0, ddof=1) / PASSES


def dark(random: np.random.Generator) -> Ratio:
    """Six standard errors from black, where a symmetric interval around the ratio would not do.

    The pixels are so many that their variances count as exact."""
    a, b = random.normal(6, 1), random.normal(TRUTH * 6, 0.1)
    each = np.full(1000, 1e-3)
    return ratio_from_variances(a * each, b * each, each, each / 100)


@pytest.mark.parametrize(
    "measure",
    [
        by_variance,
        by_tiles,
        in_brightest_by_variance,
        in_brightest_by_tiles,
        splatted_by_variance,
        splatted_by_tiles,
        few_by_variance,
    ],
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


def test_correlation_of_independent_pixels_is_none() -> None:
    """Also where B / A has an edge: only the squares on it see that."""
    random = np.random.default_rng(0)
    shape = (256, 256)
    mean = np.ones(shape)
    (a, var_a), (b, var_b) = renders(mean, random), renders(mean, random)
    assert noise_correlation(a, b, var_a, var_b) == pytest.approx(1, abs=0.05)
    b[100:200, 100:200] *= 3
    var_b[100:200, 100:200] *= 9
    assert noise_correlation(a, b, var_a, var_b) == pytest.approx(1, abs=0.05)


def test_correlation_is_that_of_the_filter() -> None:
    """A box of 2 x 2 makes of every pixel's noise four times its part of the sum."""
    random = np.random.default_rng(0)
    a, b = (1 + 0.1 * _boxed(random.normal(0, 1, (256, 256))) for _ in range(2))
    variance = np.full(a.shape, 0.01)
    assert noise_correlation(a, b, variance, variance) == pytest.approx(4, rel=0.1)


def _boxed(noise: FloatArray) -> FloatArray:
    """Of variance 1 again."""
    boxed: FloatArray = 2 * ndimage.uniform_filter(noise, 2, mode="wrap")
    return boxed


@pytest.mark.parametrize("shape", [(1, 1), (15, 100), (16, 16)])
def test_correlation_of_small_and_black_pictures(shape: tuple[int, int]) -> None:
    black, one = np.zeros(shape), np.ones(shape)
    assert noise_correlation(black, black, one, one) == 1
    assert noise_correlation(one, one, black, black) == 1


def generators(count: int = SEEDS) -> Iterator[np.random.Generator]:
    return (np.random.default_rng(seed) for seed in range(count))


def test_what_is_not_lit_has_no_ratio() -> None:
    black, one = np.zeros(4), np.ones(4)
    assert not ratio_from_variances(black, one, one, one).known
    assert not ratio_from_tiles(black, one, 4).known


def test_one_tile_that_has_all_the_light_tells_no_scatter() -> None:
    a = np.array([1000.0] + 20 * [1.0])
    assert not ratio_from_tiles(a, TRUTH * a, a.size).known
    assert ratio_from_tiles(np.ones(21), TRUTH * np.ones(21), a.size).known


# -------------------------------------------------------------------------------------- what to say


def ratio(low: float, high: float) -> Ratio:
    return Ratio((low + high) / 2, low, high, 100, "jackknife")


@pytest.mark.parametrize(
    ("low", "high", "named"),
    [
        (1.77, 1.79, "one uncancelled η² = 1.777 (η = 1.333, water)"),
        (0.56, 0.57, "one uncancelled η⁻² = 0.5628 (η = 1.333, water)"),
        (2.24, 2.26, "one uncancelled η² = 2.25 (η = 1.5, glass)"),
        (34.2, 34.4, "two uncancelled η², η⁴ = 34.3 (η = 2.42, diamond)"),
        (1.78, 1.79, "None"),
        (0.9, 2.0, "None"),
        (-np.inf, np.inf, "None"),
    ],
)
def test_cause(low: float, high: float, named: str) -> None:
    assert str(likely_cause(ratio(low, high))) == named


@pytest.mark.parametrize(
    ("low", "high", "fit"),
    [
        # Two unrelated factors, and one in an interval that would hold many another number.
        (1.5, 2.5, 2),
        (1.6, 1.95, 1),
    ],
)
def test_wide_intervals_name_no_cause(low: float, high: float, fit: int) -> None:
    wide = ratio(low, high)
    assert len(fitting_causes(wide)) == fit
    assert likely_cause(wide) is None
    told = sentence(wide, wide)
    assert "too uncertain to name a cause" in told
    assert "η" not in told


def test_causes_of_given_indices() -> None:
    assert likely_cause(ratio(1.77, 1.79), [1.5]) is None
    ice = likely_cause(ratio(1.71, 1.72), [1.309, 1.5])
    assert str(ice) == "one uncancelled η² = 1.713 (η = 1.309)"
    # Two indices so close that the interval holds both squares.
    assert likely_cause(ratio(1.70, 1.79), [1.309, 1.333]) is None


@pytest.mark.parametrize(
    ("low", "high", "told"),
    [
        (1.767, 1.787, "1.777 ± 0.010"),
        (1.5, 2.5, "2.00 ± 0.50"),
        (100, 160, "130 ± 30"),
        (1.5, 1.5, "1.5"),
        (0.9e38, 1.1e38, "1e+38 ± 1e+37"),
    ],
)
def test_interval(low: float, high: float, told: str) -> None:
    assert interval_text(ratio(low, high)) == told


def test_sentence_of_different_outcomes() -> None:
    water, none, hidden = ratio(1.77, 1.79), ratio(0.95, 1.05), ratio(-np.inf, np.inf)
    assert sentence(none, water) == (
        "B is 1.780 ± 0.010 × as bright as A in the brightest 5 % of the pixels: possibly one "
        "uncancelled η² = 1.777 (η = 1.333, water); B is 1.000 ± 0.050 × as bright as A over the "
        "whole picture: no difference is resolved (95% confidence each)."
    )
    assert sentence(hidden, none) == (
        "B is 1.000 ± 0.050 × as bright as A in the brightest 5 % of the pixels: no difference is "
        "resolved; noise hides the ratio over the whole picture (95% confidence each)."
    )
    assert sentence(none, none) == (
        "B is 1.000 ± 0.050 × as bright as A in the brightest 5 % of the pixels and 1.000 ± 0.050 "
        "× over the whole picture (95% confidence each): no difference is resolved."
    )


def test_lopsided_interval_is_told_by_its_ends() -> None:
    """2.3 ± 2.5 would seem to hold 1, which this does not."""
    assert interval_text(Ratio(2.3, 1.1, 4.8, 100, "variance")) == "2.3 (1.1 to 4.8)"
