"""Claimed errors are true: the small version of tests/honesty.

Seeds are fixed. Were others drawn, a case whose mean ratio of actual over claimed relMSE lies
anywhere within the bar would fail once in ten thousand times on either side, and one without bias
as often for its brightness: Student's t of independent renders, whose standard error there has that
of the reference in it, which they have in common.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from honesty.cases import BAR, Case
from honesty.claims import Claims, FloatArray, Reference, claims, open_stage, reference

FALSE_ALARM = 1e-4
SEEDS = 20
#: The means must be known to this, else nothing was shown. Claims that are off by 1.7 fail surely:
#: 1.7 (1 - 0.25) and (1 + 0.25) / 1.7 are outside of the bar.
RESOLUTION = 0.25
BRIGHTNESS_RESOLUTION = 0.02


@pytest.mark.parametrize(
    "case",
    [Case("cornell_box", "light", (0.2,)), Case("bump_sphere", "bdpt", (0.1,))],
    ids=lambda case: case.stage,
)
def test_claims_are_true(case: Case) -> None:
    """And no light is lost: ending when noise looks small favours pictures that have met no bright
    sample yet."""
    stage = open_stage(case.stage)
    (target,) = case.targets
    against = reference(stage, case.reference_options())
    assert against.error <= case.reference_error
    found = claims(stage, against, case.options(target), range(SEEDS))
    assert (found.claimed < target**2).all()
    assert (found.claimed > (target / 2) ** 2).all()

    mean, margin = interval(found.ratios, float(stats.sem(found.ratios)))
    assert margin < RESOLUTION
    assert mean + margin > BAR[0]
    assert mean - margin < BAR[1]

    mean, margin = interval(found.brightness, found.brightness_error(against))
    assert margin < BRIGHTNESS_RESOLUTION
    assert abs(mean - 1) < margin


def test_brightness_counts_the_reference() -> None:
    """A sixteenth of one seed's variance is more than a twentieth, which 20 seeds have."""
    rng = np.random.default_rng(1)
    against = Reference(np.ones((4, 4, 3)), 0.0, 0.25)
    values = rng.normal(1.0, 1.0, SEEDS)
    found = Claims(values, values, values, values, values)
    expected = np.hypot(stats.sem(values), 0.25 * values.mean())
    assert found.brightness_error(against) == pytest.approx(expected)


def interval(values: FloatArray, error: float) -> tuple[float, float]:
    """The mean, and what it may be off by."""
    return float(values.mean()), float(stats.t.isf(FALSE_ALARM, SEEDS - 1) * error)
