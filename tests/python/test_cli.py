"""The command line."""

from __future__ import annotations

import json
import os
import pty
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from PIL import Image as PilImage

import etendue
from etendue import cli
from etendue.presets import PRESETS
from support.exr_header import read_exr_header
from support.stage_builder import StageBuilder

SMALL = ["--resolution", "16x12", "--spp", "2"]


@pytest.fixture
def file(build: StageBuilder, tmp_path: Path) -> Path:
    """A lit quad."""
    path = tmp_path / "quad.usda"
    build.lit_quad().stage.Export(str(path))
    return path


def command(*arguments: object) -> list[str]:
    """The same command line in a process of its own."""
    return [sys.executable, "-m", "etendue.cli", *map(str, arguments)]


def error_line(capsys: pytest.CaptureFixture[str]) -> str:
    """The only line on stderr."""
    captured = capsys.readouterr()
    assert captured.out == ""
    (line,) = captured.err.splitlines()
    assert line.startswith("etendue: error: ")
    return line


# ------------------------------------------------------------------------------------------ render


def test_render_exr(file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "a.exr"
    arguments = [*SMALL, "--aov", "depth", "--aov", "normal", "--seed", "3", "--filter", "gaussian"]
    assert cli.run(["render", str(file), "-o", str(out), *arguments]) == 0
    header = read_exr_header(out)
    assert header["channels"] == [
        *("A", "B", "G", "R", "depth.Z"),
        *("normal.X", "normal.Y", "normal.Z"),
    ]
    assert header["etendue:seed"] == "3"
    assert header["etendue:stage"] == str(file)
    assert f"wrote {out}: 16x12, 2 spp" in capsys.readouterr().err


def test_render_auto(file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """What it tells are options that repeat the render."""
    out = tmp_path / "a.exr"
    assert cli.run(["render", str(file), "-o", str(out), *SMALL, "--integrator", "auto"]) == 0
    chosen = "--integrator bdpt"
    assert f"2 spp, auto chose {chosen}" in capsys.readouterr().err
    assert read_exr_header(out)["etendue:chosen"] == chosen
    arguments = ["render", str(file), "-o", str(out), *SMALL, "--integrator", "auto"]
    assert cli.run([*arguments, "--light-paths", "1"]) == 1
    assert "chooses strategies and light paths itself" in capsys.readouterr().err


def test_render_strategy_images(file: Path, tmp_path: Path) -> None:
    out = tmp_path / "a.exr"
    assert cli.run(["render", str(file), "-o", str(out), *SMALL, "--strategy-images", "1"]) == 0
    channels = read_exr_header(out)["channels"]
    assert isinstance(channels, list)
    assert [name for name in channels if name.startswith("st.weighted.")] == [
        *("st.weighted.s0t2.B", "st.weighted.s0t2.G", "st.weighted.s0t2.R"),
        *("st.weighted.s1t1.B", "st.weighted.s1t1.G", "st.weighted.s1t1.R"),
    ]


def test_render_adaptively(file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Such renders know their error."""
    render = ["render", str(file), "-o", str(tmp_path / "a.exr"), "--resolution", "8x6"]
    assert cli.run([*render, "--spp", "17", "--adaptive"]) == 0
    assert re.search(r"wrote .*17 spp, error \S+%", capsys.readouterr().err)


def test_render_png(file: Path, tmp_path: Path) -> None:
    out = tmp_path / "a.png"
    options = ["--bits", "16", "--crop", "1,2,9,10", "--integrator", "path", "--threads", "1"]
    assert cli.run(["render", str(file), "-o", str(out), *SMALL, *options]) == 0
    with PilImage.open(out) as picture:
        assert picture.size == (8, 8)


def test_plain_lines_without_a_terminal(file: Path, tmp_path: Path) -> None:
    out = tmp_path / "a.exr"
    done = subprocess.run(
        command("render", file, "-o", out, *SMALL), capture_output=True, text=True, check=True
    )
    assert done.stdout == ""
    lines = done.stderr.splitlines()
    assert re.fullmatch(r"rendering: 2/2 spp, .*done in .* s", lines[-2])
    assert lines[-1].startswith(f"wrote {out}")
    assert "\x1b" not in done.stderr
    assert "\r" not in done.stderr


def test_bar_on_a_terminal(file: Path, tmp_path: Path) -> None:
    master, slave = pty.openpty()
    with subprocess.Popen(
        command("render", file, "-o", tmp_path / "a.exr", *SMALL),
        stderr=slave,
        env={**os.environ, "TERM": "xterm", "COLUMNS": "100"},
    ) as process:
        os.close(slave)
        shown = b""
        while True:
            try:
                chunk = os.read(master, 4096)
            except OSError:  # the other end is closed
                break
            if not chunk:
                break
            shown += chunk
        assert process.wait() == 0
    os.close(master)
    assert b"2/2 spp" in shown
    assert b"\x1b" in shown


def test_quiet(file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["render", str(file), "-o", str(tmp_path / "a.exr"), *SMALL, "--quiet"]) == 0
    captured = capsys.readouterr()
    assert captured.out + captured.err == ""


def test_warnings_are_lines(
    build: StageBuilder, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "a.usda"
    build.lit_quad().quad("/Bad", points=[])
    build.stage.Export(str(file))
    assert cli.run(["render", str(file), "-o", str(tmp_path / "a.exr"), *SMALL, "-q"]) == 0
    assert capsys.readouterr().err == (
        "etendue: warning: /Bad: the mesh is skipped: it has no points\n"
    )


def test_preset(file: Path, tmp_path: Path) -> None:
    """What is given besides replaces what it sets, and nothing else."""
    out = tmp_path / "a.exr"
    arguments = ["render", str(file), "-o", str(out), "--resolution", "16x12", "--preset", "draft"]
    assert cli.run(arguments) == 0
    assert 0 < float(str(read_exr_header(out)["etendue:error"])) < PRESETS["draft"].error
    assert read_exr_header(out)["etendue:spp"] == "16"
    assert cli.run([*arguments, "--spp", "9"]) == 0
    assert read_exr_header(out)["etendue:spp"] == "9"
    assert cli.run([*arguments, "--error", "0.02"]) == 0
    assert float(str(read_exr_header(out)["etendue:error"])) < 0.02


def test_error_ends_the_render(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "a.exr"
    arguments = ["--resolution", "16x12", "--error", "0.2"]
    assert cli.run(["render", str(file), "-o", str(out), *arguments]) == 0
    claimed = float(str(read_exr_header(out)["etendue:error"]))
    assert 0 < claimed < 0.2
    told = capsys.readouterr().err.splitlines()
    assert re.search(r" spp, error [0-9.]+%, .*done in", told[-2])
    match = re.search(r" spp, error ([0-9.]+)%, ", told[-1])
    assert match
    assert float(match[1]) / 100 == pytest.approx(claimed, rel=0.01)


def test_black_picture_claims_no_error(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Emission alone, of a lamp that is out of view."""
    arguments = ["-o", str(tmp_path / "a.exr"), "--resolution", "8x6", "--error", "0.2"]
    assert cli.run(["render", str(file), *arguments, "--max-depth", "0"]) == 0
    told = capsys.readouterr().err.splitlines()[-1]
    assert "nothing seen" in told
    assert "error" not in told


@pytest.mark.usefixtures("ctrl_c_interrupts")
def test_ctrl_c_writes_what_there_is(file: Path, tmp_path: Path) -> None:
    out = tmp_path / "a.exr"
    with subprocess.Popen(
        command("render", file, "-o", out, "--resolution", "64x48", "--time", "600"),
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stderr is not None
        process.stderr.readline()  # the first line of progress: it renders
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        rest = process.stderr.read()
        assert process.wait(30) == 130
    assert "interrupted, wrote" in rest
    assert "Traceback" not in rest
    assert int(str(read_exr_header(out)["etendue:spp"])) >= 1


# ------------------------------------------------------------------------------------------ errors


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--camera", "/Nowhere"], "'/Nowhere' is not a camera of the stage; cameras: /Camera"),
        (["--integrator", "magic"], "unknown integrator 'magic'"),
        (["--aov", "beauty"], "unknown aov 'beauty'"),
        (["--crop", "0,0,99,99"], "outside of the image"),
        (["--integrator", "path", "--strategy-images", "3"], "strategy images need the bdpt"),
        (["--time", "-1"], "time is -1.0"),
        (["--error", "0"], "error is 0.0; it must be a positive number, 0.05 for 5 %"),
        (["--error", "nan"], "error is nan"),
        (
            ["--preset", "best"],
            "unknown preset 'best'; there are: draft, preview, final, reference",
        ),
        (["--view", "nothing", "-o", "OUT.png"], "nothing"),
        (["--ocio", "missing.ocio", "-o", "OUT.png"], "missing.ocio"),
        (["-o", "OUT.gif"], "OUT.gif"),
        (["-o", "OUT"], "OUT"),
        (["-o", "nowhere/OUT.exr"], "nowhere/OUT.exr"),
    ],
)
def test_errors(
    file: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    arguments: list[str],
    message: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    before = set(tmp_path.iterdir())
    assert cli.run(["render", str(file), "-o", "a.exr", *SMALL, *arguments]) == 1
    assert message in error_line(capsys)
    assert set(tmp_path.iterdir()) == before


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "Missing"),
        (["--spp", "many"], "--spp"),
        (["--resolution", "big"], "--resolution wants WIDTHxHEIGHT, not 'big'"),
        (["--crop", "1,2,3"], "--crop wants X0,Y0,X1,Y1"),
        (["--bits", "12", "-o", "a.png"], "--bits is 8 or 16"),
        (["--strategy-images", "3", "-o", "a.png"], "'a.png': --strategy-images are layers of an"),
        (["--nonsense"], "--nonsense"),
    ],
)
def test_usage_errors(
    file: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    arguments: list[str],
    message: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    output = ["-o", "a.exr"] if arguments else []
    assert cli.run(["render", str(file), *output, *arguments]) == 2
    assert message in error_line(capsys)


def test_missing_stage(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    missing = tmp_path / "missing.usda"
    assert cli.run(["render", str(missing), "-o", str(tmp_path / "a.exr")]) == 1
    assert error_line(capsys) == f"etendue: error: {missing}: no such file"


def test_no_stage(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "a.usda"
    file.write_text("hello")
    assert cli.run(["render", str(file), "-o", str(tmp_path / "a.exr")]) == 1
    assert f"{file}: not a USD stage" in error_line(capsys)


@pytest.mark.parametrize(
    ("left_out", "message"), [("/Camera", "no camera"), ("/Light", "no light")]
)
def test_stage_that_lacks_something(
    build: StageBuilder,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    left_out: str,
    message: str,
) -> None:
    file = tmp_path / "a.usda"
    build.lit_quad().stage.RemovePrim(left_out)
    build.stage.Export(str(file))
    assert cli.run(["render", str(file), "-o", str(tmp_path / "a.exr")]) == 1
    line = error_line(capsys)
    assert str(file) in line
    assert message in line


def test_debug_shows_the_traceback(tmp_path: Path) -> None:
    with pytest.raises(etendue.FileError):
        cli.run(["--debug", "inspect", str(tmp_path / "missing.usda")])


def test_read_only_output_is_refused_before_the_stage_is_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.run(["render", str(tmp_path / "missing.usda"), "-o", "/proc/a.exr"]) == 1
    assert "/proc/a.exr" in error_line(capsys)


# ----------------------------------------------------------------------------------------- inspect


def test_inspect(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["inspect", str(file)]) == 0
    out = capsys.readouterr().out
    for word in ("/Camera", "1 Sphere", "1 Mesh", "areas", "BVH: "):
        assert word in out


def test_inspect_json(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["inspect", str(file), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["cameras"] == ["/Camera"]
    assert told["triangles"] == 2
    assert told["lights"] == {"Sphere": 1}
    assert told["requirements"]["lights"] == ["areas"]
    assert told["requirements"]["lobes"] == ["diffuse"]
    assert told["memory"]["acceleration"] > 0
    assert told["unsupported"] == []


def test_inspect_without_camera_or_light(
    build: StageBuilder, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "a.usda"
    build.quad(subdivisionScheme="loop")
    build.stage.Export(str(file))
    assert cli.run(["inspect", str(file)]) == 0
    assert "subdivisionScheme 'loop' is not supported" in capsys.readouterr().out


# -------------------------------------------------------------------------------------------- rest


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["--version"]) == 0
    assert capsys.readouterr().out == f"etendue {etendue.__version__}\n"


@pytest.mark.parametrize("arguments", [["--help"], ["render", "--help"], ["inspect", "--help"]])
def test_help(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(arguments) == 0
    assert "etendue" in capsys.readouterr().out


def test_no_arguments_show_the_help(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run([]) == 2
    captured = capsys.readouterr()
    assert "render" in captured.out
    assert captured.err == ""


def test_main_ends_the_process(tmp_path: Path) -> None:
    with pytest.raises(SystemExit) as ended:
        cli.main(["inspect", str(tmp_path / "missing.usda")])
    assert ended.value.code == 1
