"""`etendue tradeoff`: what it prints and writes, its status."""

from __future__ import annotations

import functools
import json
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

import etendue
from etendue import cli
from etendue.settings import RenderOptions
from etendue.stage import Stage
from etendue.tradeoff import command
from etendue.tradeoff.rendering import Snapshot, StageRenderer
from etendue.tradeoff.report.json_file import SCHEMA
from etendue.tradeoff.runner import MakeRenderer, tradeoff
from support.made_up_renders import WAYS, MadeUp, made_up_stage
from support.validation_results import picture

NAMES = ("path", "bdpt")


@pytest.fixture
def stage(tmp_path: Path) -> str:
    """A lit quad."""
    file = tmp_path / "quad.usda"
    built = made_up_stage()
    built.GetRootLayer().Export(str(file))
    return str(file)


def measure_with(monkeypatch: pytest.MonkeyPatch, interrupt: tuple[str, int] = ("", 0)) -> None:
    def renderer(stage: Stage, camera: str | None, resolution: tuple[int, int]) -> MadeUp:
        del stage, camera, resolution
        return MadeUp(WAYS, picture(), interrupt)

    use(monkeypatch, renderer)


def use(monkeypatch: pytest.MonkeyPatch, renderer: MakeRenderer) -> None:
    monkeypatch.setattr(command, "tradeoff", functools.partial(tradeoff, renderer=renderer))


@pytest.fixture(autouse=True)
def _work_elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where reports without a place of their own may go."""
    monkeypatch.chdir(tmp_path)


def refused(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    """The one line of it, and that nothing was rendered before."""
    assert cli.run(["tradeoff", *arguments]) in (1, 2)
    captured = capsys.readouterr()
    assert captured.out == ""
    (line,) = captured.err.splitlines()
    assert line.startswith("etendue: error: ")
    return line.removeprefix("etendue: error: ")


def only(*names: str) -> list[str]:
    return [part for name in names for part in ("--only", name)]


class FixedPace(StageRenderer):
    """Our own renders, as if every pass took as long on all machines: passes do not depend on the
    clock, nor do pictures, errors and what is concluded from them."""

    PASS_SECONDS = 4e-4

    def pass_seconds(self, options: RenderOptions, limit: float, seed: int) -> float:
        del options, limit, seed
        return self.PASS_SECONDS

    def snapshots(
        self, options: RenderOptions, rungs: Sequence[int], seed: int
    ) -> Sequence[Snapshot]:
        taken = super().snapshots(options, rungs, seed)
        return [replace(one, seconds=one.passes * self.PASS_SECONDS) for one in taken]


def test_a_real_stage(
    stage: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """With our own renders: path and bdpt agree. Seed and passes are fixed, so it holds or fails
    on all machines alike; with other seeds a floor would be seen twice in 1,000 times."""
    use(monkeypatch, FixedPace)
    out = tmp_path / "new" / "report"
    arguments = ["tradeoff", stage, "--resolution", "32x32", "--time", "0.6", "--seed", "5"]
    assert cli.run([*arguments, *only(*NAMES), "--out", str(out)]) == 0
    captured = capsys.readouterr()
    assert captured.err.splitlines() == [
        "measuring 1/8: reference",
        "measuring 2/8: trials",
        *(f"measuring {number + 2}/8: round {number}" for number in range(1, 7)),
        f"wrote {out / 'index.html'}",
    ]
    assert "Best here is" in captured.out
    assert captured.out.count("converges") == 2
    document = json.loads((out / "results.json").read_text(encoding="utf-8"))
    jsonschema.validate(document, json.loads(SCHEMA.read_text(encoding="utf-8")))
    assert (document["seed"], document["resolution"]) == (5, [32, 32])
    assert [one["name"] for one in document["candidates"]] == list(NAMES)
    for one in document["candidates"]:
        assert [rung["passes"] for rung in one["rungs"]] == [1, 2, 4, 9, 19, 38, 77]
        # Samples of a render are spread evenly: it is no flatter than noise makes it.
        assert one["slope"]["low"] < -0.9
        assert one["brightness"]["value"] == pytest.approx(1, abs=0.02)
    assert (out / "results.csv").exists()
    assert "quad.usda" in (out / "index.html").read_text(encoding="utf-8")


def test_a_reference_file(
    stage: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """It sets the size; without a variance nobody is said to converge.

    The report is named by the stage.
    """
    measure_with(monkeypatch)
    file = tmp_path / "right.exr"
    etendue.open(stage).render(resolution=(32, 24), spp=1).save(file)
    arguments = ["tradeoff", stage, "--reference", str(file)]
    assert cli.run([*arguments, *only("light")]) == 0
    captured = capsys.readouterr()
    assert captured.err.splitlines()[0] == "measuring 1/7: trials"
    assert "does not say how noisy it is" in captured.out
    document = json.loads((tmp_path / "quad-tradeoff" / "results.json").read_text(encoding="utf-8"))
    assert document["resolution"] == [32, 24]
    assert document["reference"]["rel_mse"] is None
    assert document["candidates"][0]["verdict"] == "unknown"


@pytest.mark.parametrize(
    ("when", "told", "kept"),
    [
        (("bdpt", 4), "interrupted after 3 rounds", ["path", "light", "bdpt"]),
        (("light", 2), "interrupted after 2 rounds, 2 candidates not measured", ["path"]),
    ],
)
def test_interrupted(
    when: tuple[str, int],
    told: str,
    kept: list[str],
    stage: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """All are kept that have two renders."""
    measure_with(monkeypatch, interrupt=when)
    arguments = ["tradeoff", stage, "--resolution", "32x24", *only("path", "light", "bdpt")]
    assert cli.run([*arguments, "--out", str(tmp_path / "out")]) == 130
    assert told in " ".join(capsys.readouterr().out.split())
    document = json.loads((tmp_path / "out" / "results.json").read_text(encoding="utf-8"))
    assert document["interrupted"]
    assert [one["name"] for one in document["candidates"]] == kept
    assert document["not_run"] == [name for name in ("path", "light", "bdpt") if name not in kept]


@pytest.mark.parametrize("when", [("reference", 0), ("light", 0), ("light", 2)])
def test_interrupted_before_anything_was_found(
    when: tuple[str, int],
    stage: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    measure_with(monkeypatch, interrupt=when)
    out = tmp_path / "out"
    arguments = ["tradeoff", stage, "--resolution", "32x24", *only("light"), "--out", str(out)]
    assert cli.run(arguments) == 130
    assert capsys.readouterr().out == ""
    assert list(out.iterdir()) == []


def test_refusals(stage: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    told = refused(capsys, stage, "--only", "photons")
    assert told.startswith("unknown candidate 'photons'; there are: path, ")
    told = refused(capsys, stage, "--time", "0")
    assert told == "time is 0.0; it must be a positive number of seconds"
    told = refused(capsys, stage, "--resolution", "wide")
    assert told.startswith("Invalid value: --resolution wants WIDTHxHEIGHT, not 'wide'")
    told = refused(capsys, stage, "--resolution", "0x10")
    assert told == "resolution is 0; it must be 1 or more"
    assert "'nobody' is not a camera" in refused(capsys, stage, "--camera", "nobody")
    assert "nowhere.usda" in refused(capsys, str(tmp_path / "nowhere.usda"))
    assert "nothing.exr" in refused(capsys, stage, "--reference", str(tmp_path / "nothing.exr"))
    (tmp_path / "file").write_text("in the way", encoding="utf-8")
    told = refused(capsys, stage, "--out", str(tmp_path / "file" / "report"))
    assert told == f"{tmp_path / 'file' / 'report'}: Not a directory"


def test_reference_that_does_not_fit(
    stage: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    opened = etendue.open(stage)
    whole, part = tmp_path / "whole.exr", tmp_path / "part.exr"
    opened.render(resolution=(8, 8), spp=1).save(whole)
    opened.render(resolution=(8, 8), crop=(4, 2, 8, 8), spp=1).save(part)
    told = refused(capsys, stage, "--resolution", "16x16", "--reference", str(whole))
    assert told == f"{whole}: is 8x8, but 16x16 was asked for"
    told = refused(capsys, stage, "--reference", str(part))
    assert told == f"{part}: is a crop of 4x6 at 4, 2; a reference is whole"
    opened.render(resolution=(8, 8), crop=(0, 0, 4, 4), spp=1).save(part)
    told = refused(capsys, stage, "--reference", str(part))
    assert told == f"{part}: is a crop of 4x4 at 0, 0; a reference is whole"


def test_api(stage: str) -> None:
    """From an open stage, in this machine's own time: what is said of pictures does not depend on
    how many passes fit into it."""
    steps: list[Any] = []
    found = etendue.tradeoff(
        etendue.open(stage),
        time=0.2,
        only=["light"],
        resolution=(12, 9),
        progress=lambda *step: steps.append(step),
    )
    assert steps[:2] == [("reference", 0, 8), ("trials", 1, 8)]
    assert found["light"].picture.shape == (9, 12, 3)
    assert np.isfinite(found["light"].picture).all()
    times = [rung.seconds for rung in found["light"].rungs]
    assert times == sorted(times)
    assert times[0] > 0
    with pytest.raises(KeyError):
        found["path"]
