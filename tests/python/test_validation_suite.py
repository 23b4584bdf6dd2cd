"""The suite runs its cases, all or chosen ones, and says what it takes."""

from __future__ import annotations

import sys
from collections import Counter

import pytest

import etendue
from etendue.validation import case_names, validate
from etendue.validation.cases import CASES
from etendue.validation.claims import FALSE_ALARM
from etendue.validation.effort import FULL, QUICK, Effort
from etendue.validation.errors import CORRECTIONS
from etendue.validation.results import Check, ValidationResult
from etendue.validation.shots import stages_folder
from support.planted_errors import (
    honest,
    honest_run,
)
from support.recorder import Recorder


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
