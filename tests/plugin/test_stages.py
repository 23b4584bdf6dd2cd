"""Our stages through Hydra and through the stage reader."""

from __future__ import annotations

from pathlib import Path

import pytest

from support.hydra_host import SCENE_INDEX, HydraHost
from support.hydra_stages import NAMES, SAMPLES, WIDTH, first_camera, reference, stage_file
from support.same_picture import Picture, assert_same_picture, read_color

# Hosts without scene indices do not hand over implicit surfaces and shaders of our own.
PLAIN = ("bump_plane", "caustic_pool", "cornell_box", "cornell_indirect", "flat_pool")


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
