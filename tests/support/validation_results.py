"""Small results of a validation, made up: no renderer has any part in them."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from etendue.validation.results import (
    CaseResult,
    Check,
    Cost,
    Estimate,
    PicturePair,
    Plot,
    Pyramid,
    Series,
    ValidationResult,
)

FloatArray = npt.NDArray[np.float64]

WATER = 1.333**2
LEVEL = 0.95


def estimate(value: float, arm: float) -> Estimate:
    return Estimate(value, value - arm, value + arm, LEVEL)


def check(name: str, predicted: float = WATER, measured: float = WATER) -> Check:
    """It holds where the measurement is within a hundredth."""
    passed = abs(measured - predicted) < 0.01
    return Check(
        name=name,
        quantity="wrong / right",
        stage="flat_water.usda",
        camera="underwater",
        integrator="light",
        corrections_off=("refraction",),
        formula="η²",
        predicted=predicted,
        measured=estimate(measured, 0.005),
        p_value=0.6 if passed else 3.2e-19,
        passed=passed,
        explanations=() if passed else ("η² is applied twice",),
    )


def picture(height: int = 24, width: int = 32) -> FloatArray:
    """(h, w, 3): a dim, bluish floor with a bright line across it."""
    y, x = np.mgrid[0:height, 0:width]
    line = np.exp(-((y / height - 0.5 - 0.2 * np.sin(6 * x / width)) ** 2) / 0.002)
    color: FloatArray = (0.2 + 3 * line)[..., None] * np.array([0.7, 0.9, 1.0])
    return color


def pair(title: str = "Pool", height: int = 24, width: int = 32) -> PicturePair:
    right = picture(height, width)
    ratio = np.linspace(0.4, 2.5, height * width).reshape(height, width)
    wrong = right * ratio[..., None]
    ratio[0] = np.nan
    return PicturePair(title, "A pool.", right, wrong, ratio, 2.0, np.full((height, width), WATER))


def plot() -> Plot:
    x = (1.1, 1.333, 1.5, 2.42)
    squares = tuple(value**2 for value in x)
    low, high = (tuple(value * factor for value in squares) for factor in (0.98, 1.02))
    return Plot(
        "Ratio over η",
        "The ratio grows with η².",
        "η",
        "wrong / right",
        predicted=(
            Series("lamp", x, squares),
            Series("sun", x, tuple(1 / value for value in squares)),
        ),
        measured=(Series("lamp", x, squares, low, high),),
    )


def pyramid() -> Pyramid:
    strategies = [(s, k + 1 - s) for k in (1, 2, 3) for s in range(k + 2) if k + 1 - s > 0]
    right = {(s, t): picture() * (s + 1) / 12 for s, t in strategies}
    wrong = {(s, t): image * (WATER if s > 1 else 1.0) for (s, t), image in right.items()}
    return Pyramid("Strategies", "All of them.", right, wrong, right, wrong)


def case(name: str = "flat_water", measured: float = WATER) -> CaseResult:
    return CaseResult(
        name=name,
        title=f"Case {name}",
        lesson=("What goes wrong.", "And why: <b>ηi/ηt</b> & so on."),
        headline="the floor is 1.777 × too bright",
        checks=(check("lamp", measured=measured), check("sun")),
        figures=(pair(), plot(), pyramid()),
        costs=(Cost("flat_water.usda", "bdpt", estimate(1.02, 0.01), 8),),
        seconds=12.5,
        renders=9,
        paths=123_456,
    )


def result(*cases: CaseResult) -> ValidationResult:
    """Diagnosed if one of the cases fails."""
    shown = cases or (case(), case("pool"))
    failed = not all(one.passed for one in shown)
    return ValidationResult(
        cases=shown,
        effort="quick",
        seed=1,
        false_alarm_rate=1e-3,
        level=LEVEL,
        environment={"etendue": "0.1.0", "Python": "3.11"},
        seconds=75.0,
        diagnoses=("the factor η² is applied twice",) if failed else (),
    )
