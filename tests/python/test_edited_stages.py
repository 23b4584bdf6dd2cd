"""Stages with some of their values changed."""

from __future__ import annotations

from pathlib import Path

import pytest
from pxr import Usd

from etendue.exceptions import FileError, SceneError
from etendue.usd_reader import read_stage
from etendue.usd_reader.edited import open_edited

STAGE = """#usda 1.0
def Xform "World" (
    prepend variantSets = "shape"
    variants = {
        string shape = "plain"
    }
)
{
    variantSet "shape" = {
        "plain" {
            def Scope "Plain"
            {
                float size = 1
            }
        }
        "odd" {
            def Scope "Odd"
            {
                float size = 2
                float size.connect = </World.of>
            }
        }
    }
    float of = 7
    float moving.timeSamples = {
        0: 1,
        1: 2,
    }
}
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "stage.usda"
    path.write_text(STAGE, encoding="utf-8")
    return path


def test_unchanged(file: Path) -> None:
    stage = open_edited(file, {}, {})
    assert stage.GetPrimAtPath("/World/Plain")
    assert stage.GetAttributeAtPath("/World.of").Get() == 7


def test_variant(file: Path) -> None:
    stage = open_edited(file, {"/World{shape}": "odd"}, {})
    assert stage.GetPrimAtPath("/World/Odd")
    assert not stage.GetPrimAtPath("/World/Plain")


def test_values_are_set_within_the_chosen_variant(file: Path) -> None:
    stage = open_edited(file, {"/World{shape}": "odd"}, {"/World/Odd.size": 3.5, "/World.of": 8.0})
    assert stage.GetAttributeAtPath("/World/Odd.size").Get() == 3.5
    assert stage.GetAttributeAtPath("/World.of").Get() == 8


def test_value_stands_for_all_times(file: Path) -> None:
    stage = open_edited(file, {}, {"/World.moving": 5.0})
    moving = stage.GetAttributeAtPath("/World.moving")
    assert [moving.Get(time) for time in (0, 1)] == [5, 5]


def test_none_takes_value_and_connections_away(file: Path) -> None:
    stage = open_edited(file, {"/World{shape}": "odd"}, {"/World/Odd.size": None})
    size = stage.GetAttributeAtPath("/World/Odd.size")
    assert size.Get() is None
    assert size.GetConnections() == []


def test_file_and_later_readers_see_nothing_of_it(file: Path) -> None:
    edited = open_edited(file, {"/World{shape}": "odd"}, {"/World.of": 8.0})
    assert file.read_text(encoding="utf-8") == STAGE
    assert not edited.GetRootLayer().dirty
    again = Usd.Stage.Open(str(file))
    assert again.GetPrimAtPath("/World/Plain")
    assert again.GetAttributeAtPath("/World.of").Get() == 7


def test_what_is_read_of_it_is_called_by_its_file(file: Path) -> None:
    assert read_stage(open_edited(file, {}, {"/World.of": 8.0})).source == str(file)


@pytest.mark.parametrize(
    ("variants", "values", "place"),
    [
        ({"/Nothing{shape}": "odd"}, {}, "</Nothing> does not exist"),
        ({"/World{color}": "odd"}, {}, "</World{color}> has no variant 'odd'"),
        ({"/World{shape}": "round"}, {}, "</World{shape}> has no variant 'round'"),
        ({"/World": "odd"}, {}, "</World> has no variant 'odd'"),
        ({}, {"/Nothing.of": 1.0}, "</Nothing> does not exist"),
        ({}, {"/World.nothing": 1.0}, "</World.nothing> does not exist"),
        ({}, {"/World.nothing": None}, "</World.nothing> does not exist"),
        ({}, {"/World": 1.0}, "</World> does not exist"),
        # Not in the variant that is chosen.
        ({"/World{shape}": "odd"}, {"/World/Plain.size": 1.0}, "</World/Plain> does not exist"),
        ({}, {"/World.of": "seven"}, "</World.of> cannot be 'seven'"),
        ({}, {"/World.of": (1.0, 2.0)}, "</World.of> cannot be (1.0, 2.0)"),
    ],
)
def test_what_the_stage_does_not_have(
    file: Path, variants: dict[str, str], values: dict[str, object], place: str
) -> None:
    with pytest.raises(SceneError) as error:
        open_edited(file, variants, values)
    assert str(error.value) == f"{file}: {place}"


def test_no_file(tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"none\.usda: no such file"):
        open_edited(tmp_path / "none.usda", {}, {})
