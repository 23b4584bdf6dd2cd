"""etendue.validate()."""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import dataclass, field, replace

from etendue.exceptions import SettingsError, ValidationInterrupted
from etendue.extras import extra
from etendue.progress import StepProgress
from etendue.validation.case import Case
from etendue.validation.cases import CASES
from etendue.validation.claims import FALSE_ALARM, Claim
from etendue.validation.diagnosis import diagnose
from etendue.validation.effort import EFFORTS, Effort
from etendue.validation.environment import environment
from etendue.validation.results import CaseResult, ValidationResult
from etendue.validation.shots import Renderer, Studio, render
from etendue.validation.statistics import LEVEL, at_least_one


def validate(
    cases: Iterable[str] | None = None,
    *,
    effort: str = "quick",
    seed: int = 1,
    progress: StepProgress | None = None,
    renderer: Renderer = render,
) -> ValidationResult:
    """Renders the validation cases with and without the adjoint corrections (theory.md §5-§7).

    `cases` are names of case_names(), default all. `effort` is "quick" or "full", which has four
    times the samples and finer sweeps. The same seed gives the same result on any machine, but for
    what is timed. `renderer` makes the pictures; another one may be tried in place of ours.

    Raises SettingsError for a name that is not known, Error when the extra `report` is not
    installed, and on Ctrl-C ValidationInterrupted, which carries the cases that have finished.
    """
    chosen = _chosen(cases)
    run = _Run(_effort(effort), seed, renderer)
    extra("scipy.stats")  # missed before the work
    try:
        for number, case in enumerate(chosen):
            if progress:
                progress(case.name, number, len(chosen))
            run.add(case)
    except KeyboardInterrupt:
        if not run.cases:
            raise
        left = tuple(case.name for case in chosen[len(run.cases) :])
        raise ValidationInterrupted(replace(run.result(), not_run=left)) from None
    return run.result()


def case_names() -> tuple[str, ...]:
    """Of all cases, in the order they run."""
    return tuple(case.name for case in CASES)


@dataclass
class _Run:
    """The cases that have finished."""

    effort: Effort
    seed: int
    renderer: Renderer
    started: float = field(default_factory=time.perf_counter)
    claims: list[Claim] = field(default_factory=list)
    cases: list[CaseResult] = field(default_factory=list)

    def add(self, case: Case) -> None:
        started = time.perf_counter()
        studio = Studio(self.seed, self.renderer)
        outcome = case.run(studio, self.effort)
        result = CaseResult(
            name=case.name,
            title=case.title,
            lesson=case.paragraphs,
            headline=outcome.headline,
            checks=tuple(claim.check() for claim in outcome.claims),
            figures=outcome.figures,
            costs=outcome.costs,
            seconds=time.perf_counter() - started,
            renders=studio.renders,
            paths=studio.paths,
        )
        self.claims += outcome.claims
        self.cases.append(result)

    def result(self) -> ValidationResult:
        return ValidationResult(
            cases=tuple(self.cases),
            effort=self.effort.name,
            seed=self.seed,
            false_alarm_rate=at_least_one(FALSE_ALARM, len(self.claims)),
            level=LEVEL,
            environment=environment(),
            seconds=time.perf_counter() - self.started,
            diagnoses=diagnose(self.claims),
        )


def _chosen(names: Iterable[str] | None) -> list[Case]:
    if names is None:
        return list(CASES)
    wanted = list(names)
    for name in wanted:
        if name not in case_names():
            raise SettingsError(f"unknown case '{name}'; there are: {', '.join(case_names())}")
    return [case for case in CASES if case.name in wanted]


def _effort(name: str) -> Effort:
    for effort in EFFORTS:
        if effort.name == name:
            return effort
    known = ", ".join(effort.name for effort in EFFORTS)
    raise SettingsError(f"unknown effort '{name}'; there are: {known}")
