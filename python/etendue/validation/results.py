"""What the validation suite finds, for programs and for the report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from etendue.arrays import FloatArray

Strategy = tuple[int, int]


@dataclass(frozen=True)
class Estimate:
    """A measured ratio with its confidence interval of probability `level`."""

    value: float
    low: float
    high: float
    level: float


@dataclass(frozen=True)
class Check:
    """One prediction, held against one measurement."""

    name: str
    """Unique within its case: "η = 1.333, lamp, light"."""
    quantity: str
    """What is measured: "wrong / right", "right / closed form", "right / path"."""
    stage: str
    """File name in stages/, with the variants and values that were set."""
    camera: str
    integrator: str
    corrections_off: tuple[str, ...]
    """The adjoint corrections that the measured picture went without; empty: it is right."""
    formula: str
    """The prediction in symbols: "η²"."""
    predicted: float
    measured: Estimate
    p_value: float
    """How probable a measurement this far off is, if the prediction is true."""
    passed: bool
    """The p-value is no smaller than the rate at which a check may refuse a true prediction."""
    explanations: tuple[str, ...] = ()
    """Of a failed check: the errors in a renderer that would lead to what was measured."""


@dataclass(frozen=True, eq=False)
class PicturePair:
    """The same view with and without a correction. Arrays have row 0 on top."""

    title: str
    caption: str
    right: FloatArray
    """(h, w, 3), scene-linear Rec.709"""
    wrong: FloatArray
    """(h, w, 3)"""
    ratio: FloatArray
    """(h, w): luminance of wrong over right; NaN where there is nothing to divide."""
    full_scale: float = 2.0
    """The factor at the ends of the ratio map's colour bar."""
    predicted_ratio: FloatArray | None = None
    """(h, w), where the theory gives one for every pixel."""


@dataclass(frozen=True)
class Series:
    """Points of a plot, in order; low and high are the ends of the error bars."""

    label: str
    x: tuple[float, ...]
    y: tuple[float, ...]
    low: tuple[float, ...] = ()
    high: tuple[float, ...] = ()


@dataclass(frozen=True)
class Plot:
    """Predicted curves, drawn as lines, and measured points with error bars.

    Series of the same label belong together and share a colour.
    """

    title: str
    caption: str
    x_label: str
    y_label: str
    predicted: tuple[Series, ...]
    measured: tuple[Series, ...]
    log_y: bool = False


@dataclass(frozen=True, eq=False)
class Pyramid:
    """The images of all strategies (s, t), (h, w, 3) each; rows of the pyramid are path lengths."""

    title: str
    caption: str
    weighted_right: Mapping[Strategy, FloatArray]
    weighted_wrong: Mapping[Strategy, FloatArray]
    unweighted_right: Mapping[Strategy, FloatArray]
    unweighted_wrong: Mapping[Strategy, FloatArray]


@dataclass(frozen=True)
class Cost:
    """What a correction costs: time with it over time without it, from paired runs."""

    stage: str
    integrator: str
    ratio: Estimate
    pairs: int


Figure = PicturePair | Plot | Pyramid


@dataclass(frozen=True, eq=False)
class CaseResult:
    """One lesson: what was predicted, what was measured, and what to look at."""

    name: str
    """As --case takes it: "flat_water"."""
    title: str
    lesson: tuple[str, ...]
    """Paragraphs: what goes wrong, where, by how much, and why."""
    headline: str
    """One line for the summary: "floor under water 1.777 × too bright"."""
    checks: tuple[Check, ...]
    figures: tuple[Figure, ...] = ()
    costs: tuple[Cost, ...] = ()
    seconds: float = 0.0
    renders: int = 0
    paths: int = 0
    """Camera and light paths of all renders."""

    @property
    def passed(self) -> bool:
        return all(check.passed for check in self.checks)


@dataclass(frozen=True, eq=False)
class ValidationResult:
    """What etendue.validate() returns."""

    cases: tuple[CaseResult, ...]
    effort: str
    """"quick" or "full"."""
    seed: int
    false_alarm_rate: float
    """Of the whole suite: how often it fails although every prediction is true."""
    level: float
    """Confidence of the intervals shown, each by itself."""
    environment: Mapping[str, str]
    """Versions, machine, time."""
    seconds: float
    not_run: tuple[str, ...] = ()
    """Cases that were asked for, before Ctrl-C."""
    diagnoses: tuple[str, ...] = field(default=())
    """The errors in the renderer, in plain words, that would explain a failed check and that no
    other check contradicts."""

    @property
    def passed(self) -> bool:
        return all(case.passed for case in self.cases)

    @property
    def checks(self) -> tuple[Check, ...]:
        return tuple(check for case in self.cases for check in case.checks)
