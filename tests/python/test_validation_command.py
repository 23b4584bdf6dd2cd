"""`etendue validate`: what it prints and writes, its status."""

from __future__ import annotations

import csv
import functools
import json
import os
import pty
import sys
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from etendue import cli
from etendue.image import Image
from etendue.validation import ValidationResult, command, validate
from etendue.validation.report.json_file import SCHEMA
from etendue.validation.shots import Renderer, Shot
from support.planted_errors import dropping, honest
from support.validation_results import result

CASE = "phong"


def render_with(monkeypatch: pytest.MonkeyPatch, renderer: Renderer) -> None:
    monkeypatch.setattr(command, "validate", functools.partial(validate, renderer=renderer))


class Asked:
    """Stands for validate(), and remembers what it was called with."""

    def __init__(self, answer: ValidationResult) -> None:
        self.answer = answer
        self.arguments: dict[str, Any] = {}

    def __call__(self, cases: list[str] | None, **arguments: Any) -> ValidationResult:
        self.arguments = {"cases": cases, **arguments}
        arguments["progress"]("pond", 0, 2)
        arguments["progress"]("pool", 1, 2)
        return self.answer


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> Asked:
    """All predictions hold."""
    stand_in = Asked(result())
    monkeypatch.setattr(command, "validate", stand_in)
    return stand_in


def test_predictions_hold(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    render_with(monkeypatch, honest)
    out = tmp_path / "new" / "report"
    assert cli.run(["validate", "--case", CASE, "--out", str(out), "--seed", "3"]) == 0
    captured = capsys.readouterr()
    assert captured.err.splitlines() == [f"validating 1/1: {CASE}", f"wrote {out / 'index.html'}"]
    assert "All 20 predictions hold" in captured.out
    assert captured.out.splitlines()[-1].startswith("All 20 predictions hold, ")
    assert "failed" not in captured.out
    _check_files(out)


def _check_files(out: Path) -> None:
    """Of a real run: what was made up cannot show what a renderer's numbers do to the writers."""
    assert {file.name for file in out.iterdir()} == {"index.html", "results.csv", "results.json"}
    document = json.loads((out / "results.json").read_text(encoding="utf-8"))
    jsonschema.validate(document, json.loads(SCHEMA.read_text(encoding="utf-8")))
    assert (document["passed"], document["seed"], document["effort"]) == (True, 3, "quick")
    (case,) = document["cases"]
    assert (case["name"], case["passed"], len(case["checks"])) == (CASE, True, 20)
    assert case["paths"] > case["renders"] > 0
    with (out / "results.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["check"] for row in rows] == [check["name"] for check in case["checks"]]
    assert "Phong" in (out / "index.html").read_text(encoding="utf-8")


def test_a_prediction_fails(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    render_with(monkeypatch, dropping("phong"))
    assert cli.run(["validate", "--case", CASE, "--out", str(tmp_path)]) == 3
    lines = capsys.readouterr().out.splitlines()
    error = "the adjoint of Phong's classic form is missing"
    (first, *others) = (line for line in lines if line.startswith("failed: "))
    assert first.startswith("failed: phong: classic, view 0°, right: right / closed form is 0.7")
    assert f"), predicted 1; {error}" in first
    assert len(others) == 9
    assert f"this explains it: {error}" in lines
    assert lines[-1].startswith("10 of 20 predictions do not hold, ")
    document = json.loads((tmp_path / "results.json").read_text(encoding="utf-8"))
    assert (document["passed"], document["diagnoses"]) == (False, [error])


def test_unknown_case(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["validate", "--case", CASE, "--case", "puddle"]) == 1
    captured = capsys.readouterr()
    assert captured.out == ""
    (line,) = captured.err.splitlines()
    assert line.startswith("etendue: error: unknown case 'puddle'; there are: flat_water, ")


def test_refuses_an_output_before_it_renders(
    asked: Asked, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "file"
    file.write_text("in the way", encoding="utf-8")
    assert cli.run(["validate", "--out", str(file / "report")]) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert line == f"etendue: error: {file / 'report'}: Not a directory"
    assert asked.arguments == {}


def test_refuses_a_file_that_cannot_be_written_before_it_renders(
    asked: Asked, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "results.csv").mkdir()
    assert cli.run(["validate", "--out", str(tmp_path)]) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"etendue: error: cannot write '{tmp_path / 'results.csv'}': ")
    assert asked.arguments == {}


def test_missing_package_of_the_page_is_told_before_it_renders(
    asked: Asked,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "jinja2", None)
    assert cli.run(["validate", "--out", str(tmp_path)]) == 1
    assert "jinja2" in capsys.readouterr().err
    assert asked.arguments == {}


def test_interrupted(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Facets finish; Ctrl-C comes in the case after them."""

    def renderer(shot: Shot, spp: int, seed: int) -> Image:
        if shot.stage == "phong.usda":
            raise KeyboardInterrupt
        return honest(shot, spp, seed)

    render_with(monkeypatch, renderer)
    arguments = ["validate", "--case", "facets", "--case", "phong", "--case", "cost"]
    assert cli.run([*arguments, "--out", str(tmp_path)]) == 130
    told = "All 28 predictions hold; interrupted, 2 cases not run"
    assert capsys.readouterr().out.splitlines()[-1].startswith(f"{told}, ")
    document = json.loads((tmp_path / "results.json").read_text(encoding="utf-8"))
    assert [case["name"] for case in document["cases"]] == ["facets"]
    assert document["not_run"] == ["phong", "cost"]
    assert told in (tmp_path / "index.html").read_text(encoding="utf-8")


def test_interrupted_before_anything_was_found(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    def renderer(*_: object) -> Image:
        raise KeyboardInterrupt

    render_with(monkeypatch, renderer)
    assert cli.run(["validate", "--case", CASE, "--out", str(tmp_path)]) == 130
    assert capsys.readouterr().out == ""
    assert list(tmp_path.iterdir()) == []


def test_by_default_all_cases_run_quickly(asked: Asked) -> None:
    assert cli.run(["validate"]) == 0
    given = {name: value for name, value in asked.arguments.items() if name != "progress"}
    assert given == {"cases": None, "effort": "quick", "seed": 1}


def test_options(asked: Asked) -> None:
    assert cli.run(["validate", "--full", "--case", "a", "--case", "b", "--seed", "5"]) == 0
    given = {name: value for name, value in asked.arguments.items() if name != "progress"}
    assert given == {"cases": ["a", "b"], "effort": "full", "seed": 5}


def test_progress_is_lines_where_there_is_no_terminal(
    asked: Asked, capsys: pytest.CaptureFixture[str]
) -> None:
    assert asked.answer.passed
    assert cli.run(["validate"]) == 0
    assert capsys.readouterr().err.splitlines() == ["validating 1/2: pond", "validating 2/2: pool"]


def test_progress_is_a_bar_on_a_terminal(asked: Asked, monkeypatch: pytest.MonkeyPatch) -> None:
    assert asked.answer.passed
    ours, theirs = pty.openpty()
    monkeypatch.setenv("TERM", "xterm")
    with open(theirs, "w", encoding="utf-8") as terminal:  # noqa: PTH123 - of a descriptor
        monkeypatch.setattr(sys, "stderr", terminal)
        assert cli.run(["validate"]) == 0
        terminal.flush()
        shown = os.read(ours, 65536).decode()
    os.close(ours)
    assert "validating" in shown
    assert "1/2" not in shown
