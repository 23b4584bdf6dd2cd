"""`etendue compare`: what it prints, its page, its status."""

from __future__ import annotations

import json
import re
import struct
from pathlib import Path

import numpy as np
import numpy.typing as npt
import OpenEXR
import pytest
from playwright.sync_api import Browser

import etendue
from etendue import cli
from etendue.comparison import write_page
from support.browser import WIDTHS, check_page
from support.compared_pictures import HEIGHT, WATER, WIDTH, noisy, scene
from support.exr_file import write_channels, write_color


@pytest.fixture
def good(tmp_path: Path) -> Path:
    """Without variance."""
    return write_color(tmp_path / "a.exr", noisy(scene(), 0.02, 1))


def test_command(good: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    b = write_color(tmp_path / "b.exr", noisy(scene() * WATER, 0.02, 2))
    page = tmp_path / "out.html"
    arguments = ["compare", str(good), str(b), "--reference", str(good), "--html", str(page)]
    assert cli.run(arguments) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert "possibly one uncancelled η² = 1.777 (η = 1.333, water)" in out
    assert "jackknife over tiles" in out
    html = page.read_text(encoding="utf-8")
    assert "possibly one uncancelled η² = 1.777 (η = 1.333, water)" in html
    assert html.count("data:image/png;base64,") == 4
    # Whatever the page shows is in it.
    assert not re.findall(r"""(?:src|href)=["'](?!data:)|url\(|https?:""", html)


@pytest.mark.parametrize("width", WIDTHS)
def test_page_in_a_browser(browser: Browser, good: Path, tmp_path: Path, width: int) -> None:
    b = write_color(tmp_path / "b.exr", noisy(scene() * WATER, 0.02, 2))
    page = tmp_path / "out.html"
    write_page(etendue.compare(good, b, good), page)
    check_page(browser, page, width)


def test_names_are_escaped(good: Path, tmp_path: Path) -> None:
    odd = write_color(tmp_path / "<b>&.exr", scene())
    page = tmp_path / "out.html"
    write_page(etendue.compare(good, odd), page)
    html = page.read_text(encoding="utf-8")
    assert "<b>" not in html
    assert "&lt;b&gt;&amp;.exr" in html


@pytest.mark.parametrize("bad", ["missing.exr", "nan.exr"])
def test_command_errors(
    good: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], bad: str
) -> None:
    write_color(tmp_path / "nan.exr", np.full_like(scene(), np.nan))
    assert cli.run(["compare", str(good), str(tmp_path / bad)]) == 1
    captured = capsys.readouterr()
    assert captured.out == ""
    (line,) = captured.err.splitlines()
    assert line.startswith(f"etendue: error: {tmp_path / bad}: ")


def test_page_that_cannot_be_written(good: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["compare", str(good), str(good), "--html", "/proc/out.html"]) == 1
    assert "/proc/out.html" in capsys.readouterr().err


def plane() -> npt.NDArray[np.float32]:
    return np.ones((HEIGHT, WIDTH), np.float32)


def write_bad(folder: Path, kind: str, whole: bytes) -> Path:
    """A file, or what is none, that cannot be used."""
    bad = folder / f"{kind}.exr"
    color = scene()
    match kind:
        case "folder":
            bad.mkdir()
        case "empty" | "text" | "png" | "magic":
            start = {
                "empty": b"",
                "text": b"hello",
                "png": b"\x89PNG\r\n\x1a\n",
                "magic": whole[:4],
            }
            bad.write_bytes(start[kind])
        case "cut":
            bad.write_bytes(whole[: len(whole) // 2])
        case "absurd":
            head, size = whole.split(b"dataWindow\0box2i\0", 1)
            window = struct.pack("<4i", 0, 0, 10**6, 10**6)
            bad.write_bytes(head + b"dataWindow\0box2i\0" + size[:4] + window + size[20:])
        case "nan":
            color[2, 3, 0] = np.nan
            write_color(bad, color)
        case "black":
            write_color(bad, 0 * color)
        case "small":
            write_color(bad, color[1:])
        case "layers":
            write_channels(bad, {f"{x}.{c}": plane() for x in ("diffuse", "glossy") for c in "RGB"})
        case "colourless":
            write_channels(bad, {"depth.Z": plane()})
        case "deep":
            write_deep(bad)
    return bad


def write_deep(file: Path) -> None:
    samples = np.empty((HEIGHT, WIDTH), object)
    for pixel in np.ndindex(samples.shape):
        samples[pixel] = np.array([1, 2], np.float32)
    header = {"compression": OpenEXR.ZIPS_COMPRESSION, "type": OpenEXR.deepscanline}
    with OpenEXR.File(header, dict.fromkeys("RGB", samples)) as written:
        written.write(str(file))


@pytest.mark.parametrize(
    ("kind", "says"),
    [
        ("missing", "no such file or directory"),
        ("folder", "is a directory"),
        ("empty", "not an OpenEXR file"),
        ("text", "not an OpenEXR file"),
        ("png", "not an OpenEXR file"),
        ("magic", "cannot be read"),
        ("cut", "corrupt: its pixels cannot be read"),
        ("absurd", "corrupt: its pixels cannot be read"),
        ("nan", "channel R is nan in column 3, row 2"),
        ("black", "is black"),
        ("small", "their sizes are 48x32 and 48x31"),
        ("layers", "one layer must be chosen; there are: diffuse, glossy"),
        ("colourless", "has no channels R, G, B; there are: depth.Z"),
        ("deep", "channel R does not hold one number a pixel"),
    ],
)
def test_one_line_for_bad_files(
    good: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str], kind: str, says: str
) -> None:
    """Of the whole process: the EXR library prints past Python."""
    bad = write_bad(tmp_path, kind, good.read_bytes())
    assert cli.run(["compare", str(good), str(bad)]) == 1
    captured = capfd.readouterr()
    assert captured.out == ""
    (line,) = captured.err.splitlines()
    assert line.startswith("etendue: error: ")
    assert str(bad) in line
    assert says in line


def test_json(good: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    b = write_color(tmp_path / "b.exr", noisy(scene() * WATER, 0.02, 2))
    assert cli.run(["compare", str(good), str(b), "--json", "--no-flip"]) == 0
    told = json.loads(capsys.readouterr().out)
    found = etendue.compare(good, b, flip=False)
    assert told == found.to_dict()
    assert told["version"] == 1
    assert told["b"] == {"file": str(b), "layer": ""}
    assert told["whole"]["value"] == found.whole.value
    cause = told["brightest"]["likely_cause"]
    assert (cause["eta"], cause["power"]) == (1.333, 2)
    assert cause["factor"] == pytest.approx(1.333**2)
    assert told["b_from_a"] == {"rel_mse": found.b_from_a.rel_mse, "flip": None}
    assert told["reference"] is told["a_from_reference"] is told["z_scores"] is None


def test_json_of_what_is_not_known(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Infinity and NaN are not JSON; infinite scores count as far."""
    color = scene()
    other = color.copy()
    other[0, 0, 0] += 1
    a = write_color(tmp_path / "a.exr", color, np.zeros_like(color))
    b = write_color(tmp_path / "b.exr", other, np.zeros_like(color))
    noise = write_color(tmp_path / "n.exr", other, (1e3 * color) ** 2)
    assert cli.run(["compare", str(noise), str(b), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["whole"]["low"] is told["whole"]["high"] is None
    assert cli.run(["compare", str(a), str(b), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["z_scores"]["beyond_3"] == pytest.approx(1 / (HEIGHT * WIDTH * 3))


def test_given_index(good: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    b = write_color(tmp_path / "b.exr", noisy(scene() * 1.309**2, 0.02, 2))
    arguments = ["compare", str(good), str(b)]
    assert cli.run(arguments) == 0
    assert "uncancelled" not in capsys.readouterr().out
    assert cli.run([*arguments, "--ior", "1.309", "--ior", "1.5"]) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert "possibly one uncancelled η² = 1.713 (η = 1.309)" in out
    assert cli.run([*arguments, "--ior", "1"]) == 1
    assert "index of refraction 1: must be over 0 and not 1" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("factor", "tolerance", "status"),
    [(1.0, "0", 0), (1.02, "0.01", 3), (0.98, "0.01", 3), (1.02, "0.03", 0)],
)
def test_tolerance(good: Path, tmp_path: Path, factor: float, tolerance: str, status: int) -> None:
    """The pictures' means are known to 0.2 %."""
    b = write_color(tmp_path / "b.exr", noisy(scene() * factor, 0.02, 2))
    assert cli.run(["compare", str(good), str(b), "--tolerance", tolerance]) == status
    assert cli.run(["compare", str(good), str(b)]) == 0


def test_tolerance_where_it_is_brightest(good: Path, tmp_path: Path) -> None:
    """A wrong caustic in a picture whose mean it hardly changes."""
    color = scene()
    color[8:16, 9:27] *= 1.1
    b = write_color(tmp_path / "b.exr", noisy(color, 0.02, 2))
    assert etendue.compare(good, b).whole.low < 1.08
    assert cli.run(["compare", str(good), str(b), "--tolerance", "0.08"]) == 3


def test_tolerance_that_noise_hides(tmp_path: Path) -> None:
    color = scene()
    a = write_color(tmp_path / "a.exr", color, (1e3 * color) ** 2)
    b = write_color(tmp_path / "b.exr", 2 * color, (1e3 * color) ** 2)
    assert cli.run(["compare", str(a), str(b), "--tolerance", "0.01"]) == 0


def test_negative_tolerance(good: Path) -> None:
    assert cli.run(["compare", str(good), str(good), "--tolerance", "-1"]) == 2
