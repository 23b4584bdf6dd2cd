"""Our stages through Hydra and through the stage reader."""

from __future__ import annotations

from pathlib import Path

import pytest

import etendue
from support.hydra_host import SCENE_INDEX, HydraHost
from support.path_order import open_in_path_order
from support.same_picture import Picture, assert_same_picture, read_color, rgb

STAGES = Path(__file__).resolve().parents[2] / "stages"
NAMES = sorted(file.stem for file in STAGES.glob("*.usda"))
# Hosts without scene indices do not hand over implicit surfaces and shaders of our own.
PLAIN = ("bump_plane", "caustic_pool", "cornell_box", "cornell_indirect", "flat_pool")
WIDTH = 96
SAMPLES = 8


def stage_file(name: str) -> Path:
    """One of our stages."""
    return STAGES / f"{name}.usda"


def first_camera(name: str) -> str:
    """Its path."""
    return etendue.open(stage_file(name)).cameras[0]


def reference(name: str, ours: Picture) -> Picture:
    """The stage reader's picture, of the same size."""
    size = (ours.shape[1], ours.shape[0])
    stage = etendue.open(open_in_path_order(stage_file(name)))
    return rgb(stage.render(camera=first_camera(name), spp=SAMPLES, resolution=size))


def recorded(host: HydraHost, name: str, output: Path, **environment: str) -> Picture:
    """FrameRecorder's picture."""
    environment["HDETENDUE_SAMPLES_PER_PIXEL"] = str(SAMPLES)
    arguments = (stage_file(name), first_camera(name), WIDTH, output)
    host.run("record", *arguments, environment=environment)
    return read_color(output)


def test_there_are_stages() -> None:
    assert len(NAMES) >= 10


@pytest.mark.parametrize("name", NAMES)
def test_frame_recorder_through_scene_indices(host: HydraHost, tmp_path: Path, name: str) -> None:
    ours = recorded(host, name, tmp_path / "out.exr", **SCENE_INDEX)
    assert_same_picture(ours, reference(name, ours))


@pytest.mark.parametrize("name", PLAIN)
def test_frame_recorder_through_scene_delegates(host: HydraHost, tmp_path: Path, name: str) -> None:
    ours = recorded(host, name, tmp_path / "out.exr")
    assert_same_picture(ours, reference(name, ours))
