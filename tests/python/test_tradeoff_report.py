"""The report of `etendue tradeoff`: the page in a real browser, JSON, CSV, words."""

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
import pytest
from playwright.sync_api import Browser
from rich.console import Console

from etendue.settings import RenderOptions
from etendue.tradeoff import TradeoffResult, tradeoff
from etendue.tradeoff.candidates import CANDIDATES
from etendue.tradeoff.rendering import LongRender
from etendue.tradeoff.report import summary_table, write_report
from etendue.tradeoff.report.csv_file import COLUMNS, as_csv
from etendue.tradeoff.report.json_file import SCHEMA, as_json
from etendue.tradeoff.report.plots import highlighted, overview_url
from etendue.tradeoff.report.words import (
    cannot_be_concluded,
    choice_sentence,
    default_sentence,
    error_percent,
    headline,
    slope_sentence,
    verdict_sentence,
)
from etendue.validation.results import Estimate
from support.browser import WIDTHS, Visit, check_page
from support.json_schema import strict, undescribed
from support.made_up_renders import MadeUp, Way, made_up_result, made_up_stage
from support.validation_results import picture

NAMES = ("path", "light", "bdpt", "bdpt-no-light-image", "bdpt-depth-4")


@pytest.fixture(scope="module")
def found() -> TradeoffResult:
    """Light is best, path is noisy, bdpt-no-light-image all specks, bdpt-depth-4 lacks light."""
    return made_up_result(only=NAMES)


@pytest.fixture(scope="module")
def page(found: TradeoffResult, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_report(found, tmp_path_factory.mktemp("report") / "new")


def unknown_reference(found: TradeoffResult) -> TradeoffResult:
    """As if the reference were a file that does not know its noise."""
    reference = dataclasses.replace(found.reference, rel_mse=None, seconds=None)
    candidates = tuple(
        dataclasses.replace(one, verdict="unknown", floor_p_value=float("nan"), outliers=0.01)
        for one in found.candidates
    )
    return dataclasses.replace(found, reference=reference, candidates=candidates)


# ------------------------------------------------------------------------------------ the page


@pytest.mark.parametrize("width", WIDTHS)
def test_page(browser: Browser, page: Path, width: int) -> None:
    check_page(browser, page, width)


def test_page_says_what_to_choose_first(browser: Browser, page: Path) -> None:
    visit = Visit(browser, page, 400)
    outcome = visit.page.get_by_role("status")
    box = outcome.bounding_box()
    assert box is not None
    assert box["y"] + box["height"] < 800
    assert "Best here is light" in outcome.inner_text()
    rows = visit.page.locator("table.choices tbody tr").all_inner_texts()
    assert rows[0].split()[:2] == ["0.3", "s"]
    assert "--integrator light" in rows[0]
    for link in visit.page.locator("table a").all():
        target = link.get_attribute("href")
        assert visit.page.locator(f"article{target}").count() == 1
    visit.page.close()


def test_page_shows_every_candidate(browser: Browser, page: Path) -> None:
    visit = Visit(browser, page)
    cards = visit.page.locator("article.card")
    assert cards.count() == len(NAMES)
    assert visit.page.locator("#pictures img").count() == len(NAMES) + 1
    floor = visit.page.locator("#bdpt-depth-4")
    assert "✗ floor" in floor.inner_text()
    assert "% of the reference's light" in floor.inner_text()
    # Where it is off is shown of those that are, or may be.
    assert floor.locator(".maps img").count() == 1
    assert visit.page.locator("#light .maps").count() == 0
    visit.page.close()


def test_page_in_the_dark(browser: Browser, page: Path) -> None:
    """Dark ground, light text; drawings keep the ground they are drawn for."""
    visit = Visit(browser, page)

    def brightness(of: str) -> float:
        color = visit.page.evaluate(f"getComputedStyle(document.body).{of}")
        return sum(map(float, re.findall(r"[\d.]+", color)[:3])) / 3

    assert brightness("backgroundColor") > 200 > 100 > brightness("color")
    visit.page.emulate_media(color_scheme="dark")
    assert brightness("backgroundColor") < 60 < 200 < brightness("color")
    visit.page.close()


def test_overview_draws_the_lines(found: TradeoffResult) -> None:
    drawing = base64.b64decode(overview_url(found).split(",", 1)[1]).decode()
    for told in ("light", "path", "bdpt", "slope -1", "relMSE", "best at its time"):
        assert f">{told}<" in drawing or told in drawing
    assert highlighted(found)[0] == found.choices[0].best
    assert {"bdpt", "path", "light", "bdpt-depth-4"} <= set(highlighted(found))


# ------------------------------------------------------------------------- errors not seen


class TooModest(MadeUp):
    """Its reference claims far more noise than it has: all errors seem to be below nothing."""

    def long_render(self, options: RenderOptions, passes: int, seed: int) -> LongRender:
        image = super().long_render(options, passes, seed)
        return LongRender(image.color, 1e6 * image.variance)


EXACT = {name: Way(noise=0) for name in ("reference", "path", "bdpt")}
MODEST = {name: Way(noise=0.3) for name in ("path", "bdpt")}


def unseen(renderer: MadeUp) -> TradeoffResult:
    return tradeoff(
        made_up_stage(),
        resolution=(32, 24),
        time=30.0,
        only=["path", "bdpt"],
        renderer=lambda *_: renderer,
    )


@pytest.mark.parametrize(
    "renderer", [MadeUp(EXACT, picture()), TooModest(MODEST, picture())], ids=["exact", "modest"]
)
def test_errors_that_are_not_seen(renderer: MadeUp, tmp_path: Path) -> None:
    """A page all the same; nobody wins by having less than no error."""
    found = unseen(renderer)
    assert all(one.rungs[-1].rel_mse.value <= 0 for one in found.candidates)
    assert headline(found) == "No error is seen of bdpt: nothing here tells how good it is"
    for choice in found.choices:
        assert (choice.best, choice.as_good) == ("bdpt", ("path",))
    assert all(math.isnan(one.relative_efficiency.value) for one in found.candidates)
    assert write_report(found, tmp_path).exists()
    document = json.loads((tmp_path / "results.json").read_text(encoding="utf-8"))
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator(strict(schema)).validate(document)
    page = (tmp_path / "index.html").read_text(encoding="utf-8")
    assert not re.search(r"\bnan\b|less than none", re.sub(r'src="[^"]*"', "", page))
    console = Console(width=80, record=True, file=io.StringIO())
    console.print(summary_table(found))
    assert console.export_text().count("unknown") >= 4


def test_drawing_without_some_of_the_points(tmp_path: Path) -> None:
    """One candidate's error is seen, and it is the only one that others are measured by."""
    found = unseen(MadeUp({**EXACT, "path": Way(noise=0.3)}, picture()))
    assert found.choices[-1].best == "bdpt"
    assert found["path"].relative_efficiency.value == 1
    assert math.isnan(found["bdpt"].relative_efficiency.value)
    assert write_report(found, tmp_path).exists()


# ------------------------------------------------------------------------------------ files


def test_json_keeps_to_its_schema(found: TradeoffResult) -> None:
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    assert undescribed(schema) == []
    for one in (found, unknown_reference(found)):
        document = json.loads(as_json(one))
        jsonschema.Draft202012Validator(strict(schema)).validate(document)
    assert document["candidates"][0]["floor_p_value"] is None


def test_json_holds_the_figures(found: TradeoffResult) -> None:
    document = json.loads(as_json(found))
    by_name = {one["name"]: one for one in document["candidates"]}
    light = by_name["light"]
    assert light["rungs"][-1]["rel_mse"]["value"] == found["light"].rungs[-1].rel_mse.value
    assert light["pooled"]["rel_mse"]["low"] is None
    assert by_name["bdpt-depth-4"]["verdict"] == "floor"
    assert by_name["bdpt-depth-4"]["asked_for"] == "--max-depth 4"
    assert document["choices"][-1]["best"] == found.choices[-1].best
    assert document["front"][0]["end"] == document["front"][1]["begin"]


def test_csv_round_trip(found: TradeoffResult) -> None:
    rows = list(csv.DictReader(io.StringIO(as_csv(found), newline="")))
    assert tuple(rows[0]) == COLUMNS
    of_light = [row for row in rows if row["candidate"] == "light"]
    light = found["light"]
    assert [int(row["passes"]) for row in of_light] == [
        *(rung.passes for rung in light.rungs),
        light.pooled.passes,
    ]
    assert [row["renders"] for row in of_light] == ["1"] * len(light.rungs) + [str(found.seeds)]
    assert float(of_light[0]["rel_mse"]) == light.rungs[0].rel_mse.value
    assert float(of_light[0]["high"]) == light.rungs[0].rel_mse.high


# ------------------------------------------------------------------------------------ words


def test_verdicts_in_words(found: TradeoffResult) -> None:
    assert verdict_sentence(found["light"]).startswith("Converges to the reference")
    floor = verdict_sentence(found["bdpt-depth-4"])
    assert floor.startswith("Does not converge to the reference: 1")
    missing = re.search(r"Its picture has (9[01](\.\d)?) % of the reference's light\.", floor)
    assert missing is not None
    assert floor.endswith("It leaves out what takes more bounces, as it was told to.")
    specks = verdict_sentence(found["bdpt-no-light-image"])
    assert specks.startswith("Cannot be told: bright specks are most of its error.")
    unknown = verdict_sentence(unknown_reference(found)["light"])
    assert unknown == (
        "Whether it converges cannot be told: how noisy the reference is is not known."
    )


def test_slopes_in_words(found: TradeoffResult) -> None:
    assert slope_sentence(found["light"]).startswith("As straight as noise makes it")
    assert slope_sentence(found["bdpt-depth-4"]).startswith("Bends towards flat: ")
    assert -0.8 < found["bdpt-depth-4"].end_slope < 0
    assert found["light"].end_slope == pytest.approx(-1, abs=0.1)


def test_choices_in_words(found: TradeoffResult) -> None:
    choice = next(choice for choice in found.choices if choice.best == "light")
    told = choice_sentence(found, choice)
    assert told.startswith("Paths from the lamps, joined to the camera. The default takes 2.")
    assert told.endswith(" times as long for the same error.")
    assert headline(found).startswith("Best here is light: ")
    last = dataclasses.replace(found.choices[-1], best="bdpt")
    told = headline(dataclasses.replace(found, choices=(last,)))
    assert told.startswith("Best here is the default, bdpt: ")
    assert told.endswith(" after 10 min")
    stopped = dataclasses.replace(found, interrupted=True, not_run=("bdpt-balance",))
    assert headline(stopped).endswith("; interrupted after 6 rounds, 1 candidate not measured")


def test_no_reason_speaks_against_the_choice(found: TradeoffResult) -> None:
    """A default that seems to be better but rests on a few pixels, or seems to be as slow."""
    choice = next(choice for choice in found.choices if choice.best == "light")

    def told(noise: float, outliers: float) -> str:
        curve = dataclasses.replace(found["bdpt"].curve, noise=Estimate(noise, 0, 1, 0.95))
        default = dataclasses.replace(found["bdpt"], curve=curve, outliers=outliers)
        return default_sentence(dataclasses.replace(found, candidates=(default,)), choice)

    reached = choice.rel_mse.value * choice.seconds
    assert told(2.5 * reached, 0.03) == "The default takes 2.5 times as long for the same error."
    assert told(0.16 * reached, 0.03) == ""
    assert told(math.inf, 0.03) == ""
    assert told(0.16 * reached, 0.4).startswith("The default's figures rest on a few bright pixels")


def test_what_cannot_be_concluded_is_told(found: TradeoffResult) -> None:
    told = list(cannot_be_concluded(found))
    assert any("bdpt-no-light-image" in line and "Rare bright pixels" in line for line in told)
    assert not any("too noisy" in line for line in told)
    # Beyond the longest single render their mean has been measured.
    assert any("longer than all renders of that candidate together" in line for line in told)
    noisy = dataclasses.replace(found, reference=dataclasses.replace(found.reference, rel_mse=1.0))
    assert any("too noisy (100 %) to judge" in line for line in cannot_be_concluded(noisy))
    unknown = list(cannot_be_concluded(unknown_reference(found)))
    assert unknown[0].endswith("No candidate is said to have one, or to have none.")


@pytest.mark.parametrize(
    ("rel_mse", "told"),
    [(0.01, "10 %"), (0.0, "none seen"), (-1.0, "none seen"), (1e4, "over 1,000 %")],
)
def test_errors_in_words(rel_mse: float, told: str) -> None:
    assert error_percent(rel_mse) == told


def test_how_to_ask_for_a_candidate() -> None:
    asked_for = {candidate.name: candidate.asked_for for candidate in CANDIDATES}
    assert asked_for["bdpt"] == "the default"
    assert asked_for["path-depth-4"] == "--integrator path --max-depth 4"
    assert asked_for["bdpt-light-paths-8"] == "--light-paths 8"
    assert asked_for["bdpt-balance"] == "stage.render(heuristic='balance')"


def test_summary_table(found: TradeoffResult) -> None:
    console = Console(width=80, record=True, file=io.StringIO())
    console.print(summary_table(found))
    lines = console.export_text().splitlines()
    (light,) = (line for line in lines if "│ light " in line)
    cells = [cell.strip() for cell in light.split("│")[1:-1]]
    assert (cells[0], cells[-2], cells[-1]) == ("light", "1", "converges")
