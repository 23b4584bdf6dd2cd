"""The report of a validation: the page in a real browser, JSON, CSV and the terminal's table."""

from __future__ import annotations

import base64
import csv
import dataclasses
import io
import json
import math
import re
from pathlib import Path

import jsonschema
import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser
from rich.console import Console

import etendue
from etendue.html import common_exposure, ratio_map_url
from etendue.numbers import probability, short
from etendue.validation.report import summary_table, write_report
from etendue.validation.report.csv_file import COLUMNS, as_csv
from etendue.validation.report.intervals import marks
from etendue.validation.report.json_file import SCHEMA, as_json
from etendue.validation.report.page import as_html
from etendue.validation.report.plots import plot_url
from etendue.validation.report.pyramids import levels
from etendue.validation.report.verdicts import case_verdict, verdict
from etendue.validation.results import Check, Estimate, ValidationResult
from support.browser import WIDTHS, Visit, check_page
from support.json_schema import strict, undescribed
from support.validation_results import WATER, case, check, pair, plot, pyramid, result

FAILS = result(case(), case("pool", measured=WATER**2))
HOLDS = result()


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Of a run in which one prediction fails."""
    return write_report(FAILS, tmp_path_factory.mktemp("report") / "new" / "folder")


def hidden_by_noise(found: ValidationResult) -> ValidationResult:
    """With an interval that has no ends."""
    unknown = dataclasses.replace(
        check("dark"), measured=Estimate(math.nan, -math.inf, math.inf, 0.95)
    )
    first = dataclasses.replace(found.cases[0], checks=(*found.cases[0].checks, unknown))
    return dataclasses.replace(found, cases=(first, *found.cases[1:]))


# ------------------------------------------------------------------------------------ the page


@pytest.mark.parametrize("width", WIDTHS)
def test_page(browser: Browser, page: Path, width: int) -> None:
    check_page(browser, page, width)


def test_slider_moves(browser: Browser, page: Path) -> None:
    visit = Visit(browser, page)
    slider = visit.page.locator(".slider").first
    split = visit.page.get_by_role("slider").first

    def clip() -> str:
        wrong = slider.locator("img.wrong")
        return str(wrong.evaluate("image => getComputedStyle(image).clipPath"))

    assert clip() == "inset(0px 0px 0px 50%)"
    split.fill("20")
    assert clip() == "inset(0px 0px 0px 20%)"
    split.press("ArrowRight")
    assert clip() == "inset(0px 0px 0px 21%)"
    assert split.get_attribute("aria-valuetext") == "21 % right, the rest wrong"
    # The other one has not moved.
    assert visit.page.get_by_role("slider").nth(1).input_value() == "50"
    box = slider.bounding_box()
    assert box is not None
    slider.click(position={"x": 0.75 * box["width"], "y": 5})
    assert clip() == "inset(0px 0px 0px 75%)"
    assert split.input_value() == "75"
    visit.page.close()


def test_summary_comes_first(browser: Browser, page: Path) -> None:
    visit = Visit(browser, page, 400)
    outcome = visit.page.get_by_role("status")
    box = outcome.bounding_box()
    assert box is not None
    assert box["y"] + box["height"] < 800
    told = outcome.inner_text()
    assert "✗ 1 of 4 predictions does not hold" in told
    assert "the factor η² is applied twice" in told
    lines = visit.page.locator(".cases li").all_inner_texts()
    assert [line.split()[:2] for line in lines] == [["✓", "holds"], ["✗", "fails"]]
    for link in visit.page.locator(".cases a").all():
        target = link.get_attribute("href")
        assert visit.page.locator(f"section{target}").count() == 1
    visit.page.close()


def test_page_of_a_run_that_holds(browser: Browser, tmp_path: Path) -> None:
    visit = Visit(browser, write_report(hidden_by_noise(HOLDS), tmp_path))
    table = visit.page.locator("table.checks").first
    assert not table.is_visible()
    visit.page.locator("summary").first.click()
    assert table.is_visible()
    visit.unfold()
    told = visit.page.inner_text("body")
    assert "✓ All 5 predictions hold" in told
    assert "hidden by noise" in told
    assert "✗" not in told
    assert "What would explain it" not in told
    # What a case says is text, not markup.
    assert "And why: <b>ηi/ηt</b> & so on." in told
    assert visit.complaints == []
    visit.page.close()


def test_checks_are_told(browser: Browser, page: Path) -> None:
    visit = Visit(browser, page)
    row = visit.page.locator("#pool table.checks tbody tr").first.inner_text()
    for told in ("lamp", "1.777", "3.1573 ± 0.0050", "3.2 × 10⁻¹⁹", "η²", "refraction", "✗ fails"):
        assert told in row
    assert "η² is applied twice" in visit.page.inner_text("#pool table.checks")
    visit.page.close()


def test_page_tells_of_a_request(browser: Browser, tmp_path: Path) -> None:
    """The test above can fail."""
    page = tmp_path / "page.html"
    page.write_text(
        "<p style='font-size: 11px; width: 1300px'>x</p><script>fail()</script>"
        "<img src='http://example.invalid/a.png' alt='gone'>"
    )
    visit = Visit(browser, page)
    assert visit.pictures_that_do_not_decode() == ["gone"]
    assert len(visit.what_sticks_out()) == 2
    assert visit.smallest_text() == 11
    kinds = {complaint.split(":")[0] for complaint in visit.complaints}
    assert kinds == {"request", "console", "error"}
    visit.page.close()


@pytest.mark.parametrize("blocked", ["", "results.json", "results.csv", "index.html"])
def test_report_that_cannot_be_written(tmp_path: Path, blocked: str) -> None:
    folder = tmp_path / "report"
    if blocked:
        (folder / blocked).mkdir(parents=True)
    else:
        folder.write_text("a file")
    with pytest.raises(etendue.FileError, match=re.escape(str(folder / blocked))):
        write_report(HOLDS, folder)


# ------------------------------------------------------------------------------------ pictures


def decoded(url: str) -> Image.Image:
    return Image.open(io.BytesIO(base64.b64decode(url.split(",", 1)[1])))


def test_ratio_map_colours() -> None:
    ratio = np.array([[1.0, 2.0, 0.5, 8.0, -1.0, np.nan, math.inf, 2**0.5]])
    colors = np.asarray(decoded(ratio_map_url(ratio, 2.0)).convert("RGB"), dtype=int)[0]
    equal, bright, dark, brighter, black, nothing, infinite, half = colors
    assert (equal >= 246).all()
    assert (nothing == 128).all()
    assert bright[0] > bright[2] + 50
    assert dark[2] > dark[0] + 50
    assert (brighter == bright).all()
    assert (infinite == bright).all()
    assert (black == dark).all()
    assert bright[0] < half[0]


def test_outline_of_a_ratio_map() -> None:
    region = np.zeros((6, 6), dtype=bool)
    region[2:, 1:5] = True
    map_ = np.asarray(decoded(ratio_map_url(np.ones((6, 6)), 2.0, region)).convert("L"))
    edge = map_ == 0
    # The region goes on beyond the picture's lower end.
    assert edge.sum() == 4 + 2 * 3
    assert not edge[3:, 2:4].any()


def test_exposure_leaves_the_caustic_below_white() -> None:
    spot = np.full((20, 20, 3), 0.001)
    spot[:5, :5] = 50.0
    assert common_exposure(spot) * 50 == pytest.approx(2.0, rel=0.01)
    flat = np.full((4, 4, 3), 3.0)
    assert common_exposure(flat) == pytest.approx(0.06)
    assert common_exposure(flat, np.zeros_like(flat)) == pytest.approx(0.12)
    assert common_exposure(np.zeros_like(flat)) == 1


def test_both_of_a_pair_share_an_exposure() -> None:
    """Else a picture that is too bright all over would look like the right one."""
    bright = dataclasses.replace(pair(), wrong=pair().right * WATER)
    html = as_html(result(dataclasses.replace(case(), figures=(bright,))))
    urls = re.findall(r'<img class="(?:wrong )?few-pixels" src="([^"]+)"', html)
    right, wrong = (np.asarray(decoded(url).convert("L"), dtype=float) for url in urls[:2])
    assert wrong.mean() > right.mean() + 20


def test_plot_draws_all_points() -> None:
    drawing = base64.b64decode(plot_url(plot()).split(",", 1)[1]).decode()
    for told in ("wrong / right", "lamp", "sun", ">η<"):
        assert told in drawing
    # The same each time: no date and no random names in it.
    assert plot_url(plot()) == plot_url(plot())


def test_pyramid_places_strategies() -> None:
    weighted, wrong, _, _ = levels(pyramid())
    assert [k for k, _ in weighted.rows] == [1, 2, 3]
    for k, cells in weighted.rows:
        places = [(cell.s, cell.t) if cell else None for cell in cells]
        assert places == [(s, k + 1 - s) if s <= k else None for s in range(4)]
    ratios = {(cell.s, cell.t): cell.ratio for _, cells in wrong.rows for cell in cells if cell}
    assert ratios[1, 1] == 1
    assert ratios[2, 1] == pytest.approx(WATER)


def test_marks_of_intervals() -> None:
    found = marks([check("holds"), check("wide", 1.0, 1.004), check("fails", measured=WATER * 3)])
    holds, fails = found.of["holds"], found.of["fails"]
    assert holds.value == pytest.approx(0.5)
    assert holds.low < 0.5 < holds.high
    # 0.005 of 1.777.
    assert (holds.high - 0.5) * 2 * found.scale == pytest.approx(0.005 / WATER)
    assert (fails.beyond, holds.beyond) == ("right", "")


@pytest.mark.parametrize(
    ("value", "told"),
    [
        (WATER, "1.777"),
        (0.0, "0"),
        (2.34567e-5, "2.35 × 10⁻⁵"),
        (123456.0, "123,456"),
        (math.inf, "unknown"),
    ],
)
def test_numbers(value: float, told: str) -> None:
    assert short(value) == told


@pytest.mark.parametrize(
    ("p", "told"), [(0.0, "< 10⁻³⁰⁰"), (1.0, "1"), (0.0344, "0.034"), (3e-9, "3.0 × 10⁻⁹")]
)
def test_probabilities(p: float, told: str) -> None:
    assert probability(p) == told


# ------------------------------------------------------------------------------------ JSON and CSV


@pytest.mark.parametrize("found", [HOLDS, FAILS, hidden_by_noise(FAILS)])
def test_json_keeps_to_its_schema(found: ValidationResult) -> None:
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    document = json.loads(as_json(found))
    jsonschema.Draft202012Validator(strict(schema)).validate(document)
    assert document["passed"] == found.passed


def test_schema_describes_everything() -> None:
    assert undescribed(json.loads(SCHEMA.read_text(encoding="utf-8"))) == []


def test_json_holds_the_figures() -> None:
    document = json.loads(as_json(FAILS))
    pool = document["cases"][1]
    assert pool["checks"][0]["measured"] == {
        "value": pytest.approx(WATER**2),
        "low": pytest.approx(WATER**2 - 0.005),
        "high": pytest.approx(WATER**2 + 0.005),
        "level": 0.95,
    }
    (series,) = pool["plots"][0]["measured"]
    assert series["y"] == list(plot().measured[0].y)
    strategies = {
        (one["s"], one["t"]): one["mean"] for one in pool["pyramids"][0]["weighted_wrong"]
    }
    assert strategies[2, 1] == pytest.approx(pyramid().weighted_wrong[2, 1].mean(axis=(0, 1)))
    assert set(strategies) == set(pyramid().weighted_wrong)
    unknown = json.loads(as_json(hidden_by_noise(HOLDS)))["cases"][0]["checks"][-1]["measured"]
    assert (unknown["value"], unknown["low"], unknown["high"]) == (None, None, None)


def test_csv_round_trip() -> None:
    rows = list(csv.DictReader(io.StringIO(as_csv(FAILS), newline="")))
    assert len(rows) == len(FAILS.checks) == 4
    assert tuple(rows[0]) == COLUMNS
    for row, check_ in zip(rows, FAILS.checks, strict=True):
        measured = check_.measured
        numbers = (check_.predicted, measured.value, measured.low, measured.high, check_.p_value)
        names = ("predicted", "measured", "low", "high", "p_value")
        assert tuple(float(row[name]) for name in names) == numbers
        assert row["check"] == check_.name
        assert row["corrections_off"] == "refraction"
        assert row["passed"] == ("yes" if check_.passed else "no")
    assert [row["case"] for row in rows] == ["flat_water"] * 2 + ["pool"] * 2
    assert rows[2]["explanations"] == "η² is applied twice"


# ------------------------------------------------------------------------------------ the terminal


def test_summary_table() -> None:
    console = Console(width=100, record=True, file=io.StringIO())
    console.print(summary_table(FAILS))
    lines = console.export_text().splitlines()
    (flat,) = (line for line in lines if "flat_water" in line)
    (pool,) = (line for line in lines if "pool" in line)
    assert [cell.strip() for cell in flat.split("│")[1:4]] == ["flat_water", "2/2", "0.6"]
    assert "holds" in flat
    assert [cell.strip() for cell in pool.split("│")[1:4]] == ["pool", "1/2", "3.2 × 10⁻¹⁹"]
    assert "fails" in pool
    assert any("1 of 4 predictions does not hold" in line for line in lines)


@pytest.mark.parametrize(
    ("checks", "told"),
    [
        ((), "Nothing was predicted"),
        ((check("lamp"),), "The prediction holds"),
        ((check("lamp", measured=2.0),), "1 of 1 prediction does not hold"),
        ((check("lamp", measured=2.0),) * 2, "2 of 2 predictions do not hold"),
    ],
)
def test_verdicts(checks: tuple[Check, ...], told: str) -> None:
    one = dataclasses.replace(case(), checks=checks)
    assert verdict(result(one)) == told
    if not checks:
        assert case_verdict(one) == "measured"
