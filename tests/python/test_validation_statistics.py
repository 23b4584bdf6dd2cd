"""Intervals and p-values of the validation suite hold as often as they say."""

from __future__ import annotations

from collections.abc import Callable
from math import inf, isnan, nan, sqrt

import numpy as np
import pytest
from scipy import stats

from etendue.arrays import FloatArray
from etendue.validation.claims import BlendEvidence, BlockEvidence
from etendue.validation.pictures import blocks_of, ratio_map
from etendue.validation.statistics import LEVEL, PRECISION, Blocks, Samples, at_least_one

SEEDS = 2500
#: Independent renders behind every interval of the suite.
N = 16
#: Chance that a rate that holds fails its test, both tails together.
FALSE_ALARM = 1e-5
TRUTH = 1.777


def binomial_bounds(rate: float, seeds: int = SEEDS) -> tuple[float, float]:
    """How many of so many events of that rate there may be."""
    events = stats.binom(seeds, rate)
    return events.ppf(FALSE_ALARM / 2), events.isf(FALSE_ALARM / 2)


def renders(random: np.random.Generator, mean: float, spread: float) -> FloatArray:
    """(n,): means of renders. Their noise is the skewed sum of many paths; a spread of 0.2 is more
    than any that the suite's checks have, which is 0.04 and seldom 0.1."""
    shape = 1 / spread**2
    return random.gamma(shape, mean / shape, N)


def known_truth(random: np.random.Generator) -> Samples:
    return Samples(random.normal(TRUTH, 0.2, N), 1.0)


def known_truth_skewed(random: np.random.Generator) -> Samples:
    return Samples(renders(random, TRUTH, 0.2), 1.0)


def two_pictures(random: np.random.Generator) -> Samples:
    """The reference is the noisier one, and hardly five deviations from 0."""
    return Samples(random.normal(TRUTH, 0.2, N), random.normal(1, 0.8, N))


def two_pictures_skewed(random: np.random.Generator) -> Samples:
    return Samples(renders(random, TRUTH, 0.2), renders(random, 1.0, 0.05))


def correlated(random: np.random.Generator) -> Samples:
    """As from the same random numbers."""
    common = random.normal(0, 0.3, N)
    return Samples(TRUTH * (1 + common) + random.normal(0, 0.05, N), 1 + common)


ALL = (known_truth, known_truth_skewed, two_pictures, two_pictures_skewed, correlated)


@pytest.mark.parametrize("drawn", ALL)
def test_rates(drawn: Callable[[np.random.Generator], Samples]) -> None:
    """Intervals miss the truth, and p-values refuse it, at the rates they state."""
    random = np.random.default_rng(1)
    missed, p_values = 0, np.empty(SEEDS)
    for seed in range(SEEDS):
        samples = drawn(random)
        estimate = samples.estimate()
        missed += not estimate.low <= TRUTH <= estimate.high
        p_values[seed] = samples.p_value(TRUTH)
    low, high = binomial_bounds(1 - LEVEL)
    assert low <= missed <= high
    for rate in (0.5, 0.05, 0.005):
        low, high = binomial_bounds(rate)
        assert low <= (p_values < rate).sum() <= high


def test_interval_holds_the_ratios_that_are_not_refused() -> None:
    for seed in range(20):
        samples = two_pictures_skewed(np.random.default_rng(seed))
        estimate = samples.estimate(0.9)
        for end in (estimate.low, estimate.high):
            assert samples.p_value(end) == pytest.approx(0.1, abs=2e-4)
        assert estimate.low < estimate.value < estimate.high


def test_wider_for_more_confidence() -> None:
    samples = known_truth(np.random.default_rng(1))
    wide, narrow = samples.estimate(0.999), samples.estimate(0.9)
    assert (wide.level, narrow.level) == (0.999, 0.9)
    assert wide.low < narrow.low
    assert narrow.high < wide.high


def test_known_truth_is_students_interval() -> None:
    samples = known_truth(np.random.default_rng(2))
    mean, error = samples.measured.mean(), stats.sem(samples.measured)
    low, high = stats.t.interval(LEVEL, N - 1, mean / 2, error / 2)
    estimate = Samples(samples.measured, 2.0).estimate()
    assert estimate.value == pytest.approx(mean / 2, rel=1e-12)
    assert (estimate.low, estimate.high) == pytest.approx((low, high), rel=3 * PRECISION)
    assert Samples(samples.measured, 2.0).p_value(1.0) == pytest.approx(
        stats.ttest_1samp(samples.measured, 2.0).pvalue, rel=1e-3
    )


def test_reference_that_noise_hides() -> None:
    random = np.random.default_rng(3)
    samples = Samples(random.normal(1, 0.1, N), random.normal(0.1, 1, N))
    estimate = samples.estimate()
    assert (estimate.low, estimate.high) == (-inf, inf)


def test_no_variance() -> None:
    """Then only rounding may be between measurement and prediction."""
    samples = Samples(np.full(N, 3.0), 2.0)
    assert samples.p_value(1.5) == 1
    assert samples.p_value(1.5 * (1 + 0.9 * PRECISION)) == 1
    assert samples.p_value(1.5 * (1 + 1.1 * PRECISION)) == 0
    estimate = samples.estimate()
    assert estimate.value == 1.5
    assert estimate.low == pytest.approx(1.5 * (1 - PRECISION), abs=1e-12)
    assert estimate.high == pytest.approx(1.5 * (1 + PRECISION), abs=1e-12)


def test_rounding_does_not_hide_what_is_measured() -> None:
    random = np.random.default_rng(4)
    samples = Samples(random.normal(TRUTH, 1e-5, N), 1.0)
    assert samples.p_value(TRUTH * (1 + 3e-5)) < 1e-4


@pytest.mark.parametrize("measured", [0.0, 1.0, nan])
@pytest.mark.parametrize("reference", [0.0, nan])
def test_nothing_seen_confirms_nothing(measured: float, reference: float) -> None:
    """A black picture, or one of no numbers, agrees with no prediction."""
    for samples in (
        Samples(np.full(N, measured), np.full(N, reference)),
        Samples(np.full(N, nan), 1.0),
    ):
        assert samples.p_value(1.0) == 0
        estimate = samples.estimate()
        assert isnan(estimate.value)
        assert (estimate.low, estimate.high) == (-inf, inf)


# ------------------------------------------------------------------------------------------ blocks


def blocks(random: np.random.Generator, common: float, count: int = 12) -> Blocks:
    """Of which a share of the noise, in standard deviations, is the same in all."""
    shared = random.normal(0, common, N)
    own = sqrt(1 - common**2)
    return Blocks(
        tuple(
            Samples(TRUTH * (1 + 0.1 * (shared + random.normal(0, own, N))), 1.0)
            for _ in range(count)
        )
    )


@pytest.mark.parametrize("common", [0.0, 0.5, 0.95])
def test_worst_block_is_refused_no_more_often_than_it_should(common: float) -> None:
    """At the stated rate where blocks are independent; less often where they are not."""
    random = np.random.default_rng(5)
    seeds, rate = SEEDS // 8, 0.05
    refused = sum(blocks(random, common).p_value(TRUTH) < rate for _ in range(seeds))
    low, high = binomial_bounds(rate, seeds)
    assert refused <= high
    assert common > 0 or refused >= low


def test_worst_block_speaks() -> None:
    random = np.random.default_rng(6)
    good = [Samples(random.normal(1, 0.01, N), 1.0) for _ in range(5)]
    off = Samples(random.normal(1.05, 0.01, N), 1.0)
    found = Blocks((*good, off))
    assert found.worst(1.0) is off
    assert found.p_value(1.0) == pytest.approx(1 - (1 - off.p_value(1.0)) ** 6, rel=1e-6)
    assert BlockEvidence(found, 1.0).estimate() == off.estimate()
    assert BlockEvidence(found, 1.0).p_value(1.0) == found.p_value(1.0)


@pytest.mark.parametrize("place", range(3))
def test_worst_block_is_one_of_no_numbers(place: int) -> None:
    good = [Samples(np.random.default_rng(i).normal(1, 0.01, N), 1.0) for i in range(3)]
    good[place] = Samples(np.full(N, nan), 1.0)
    assert Blocks(tuple(good)).p_value(1.0) == 0


def test_blocks_of_a_picture() -> None:
    """Row by row; what is dark beside the rest is left out."""
    reference = np.ones((N, 4, 6))
    reference[:, :2, :3] = 0.001
    measured = reference * np.array([1.0, 2.0]).repeat(3)
    measured[:, 2:] *= 10
    ratios = [samples.ratio for samples in blocks_of(measured, reference, 2, 2).blocks]
    assert ratios == pytest.approx([2, 10, 20])


@pytest.mark.parametrize("value", [0.0, nan])
def test_blocks_of_nothing_confirm_nothing(value: float) -> None:
    nothing = np.full((N, 4, 4), value)
    for measured in (nothing, np.ones((N, 4, 4))):
        assert blocks_of(measured, nothing, 2, 2).p_value(1.0) == 0


def test_ratio_map_of_black() -> None:
    right = np.zeros((1, 2, 3))
    right[0, 1] = 0.5
    ratio = ratio_map(right, 2 * right)
    assert isnan(ratio[0, 0])
    assert ratio[0, 1] == pytest.approx(2)


def test_at_least_one() -> None:
    assert at_least_one(0.5, 2) == pytest.approx(0.75)
    assert at_least_one(1e-12, 100) == pytest.approx(1e-10, rel=1e-9)
    assert at_least_one(1.0, 3) == 1
    assert at_least_one(0.0, 3) == 0
    assert at_least_one(1e-5, 0) == 0


# ------------------------------------------------------------------------------------------- blend


def blend(random: np.random.Generator) -> BlendEvidence:
    """Two strategies share a picture; one of them is wrong by the ratio, and makes nearly all of
    the noise. The right picture and the blend come from the same renders."""
    first, second = renders(random, 0.3, 0.2), renders(random, 0.7, 0.02)
    wrong = renders(random, 0.3 * TRUTH + 0.7, 0.02)
    return BlendEvidence(wrong, first + second, TRUTH * first + second)


def test_blend_is_refused_at_the_stated_rate() -> None:
    """The prediction is measured, too, and its noise counts."""
    random = np.random.default_rng(7)
    p_values = np.empty(SEEDS)
    for seed in range(SEEDS):
        evidence = blend(random)
        p_values[seed] = evidence.p_value(evidence.predicted)
    for rate in (0.5, 0.05, 0.005):
        low, high = binomial_bounds(rate)
        assert low <= (p_values < rate).sum() <= high


def test_blend_shows_wrong_over_right() -> None:
    evidence = blend(np.random.default_rng(8))
    assert evidence.predicted == pytest.approx(evidence.blend.mean() / evidence.right.mean())
    assert evidence.estimate() == Samples(evidence.wrong, evidence.right).estimate()
    for off in (1.0, 3.0):
        assert evidence.p_value(off) < 1e-4


def test_blend_of_black_confirms_nothing() -> None:
    black = np.zeros(N)
    evidence = BlendEvidence(black, black, black)
    assert isnan(evidence.predicted)
    assert evidence.p_value(evidence.predicted) == 0
