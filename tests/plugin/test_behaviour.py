"""Pause, stop, crop, and a process with another Embree."""

from __future__ import annotations

import json
from pathlib import Path

import etendue
from support.hydra_host import HydraHost
from support.path_order import open_in_path_order
from support.same_picture import assert_same_picture, read_color, rgb

STAGES = Path(__file__).resolve().parents[2] / "stages"
SIZE = (48, 32)  # as in host/behaviour.py
CROP = (12, 4, 32, 20)
SAMPLES = 4


def test_pause_stop_and_crop(host: HydraHost, tmp_path: Path) -> None:
    stage = tmp_path / "stage.usda"
    told = json.loads(host.run("behaviour", stage, tmp_path).splitlines()[-1])
    assert told["before"] == told["after"] < told["resumed"]
    assert told["stopped"]
    assert told["restarted"]
    assert told["percent"] == 100.0
    picture = etendue.open(open_in_path_order(stage)).render(
        camera="/Camera", spp=SAMPLES, resolution=SIZE, crop=CROP
    )
    assert_same_picture(read_color(tmp_path / "crop.exr"), rgb(picture))


def test_another_embree_in_the_process_changes_nothing(host: HydraHost, tmp_path: Path) -> None:
    """Embree's symbols have no versions: calls would end in the host's."""
    pictures = []
    for script in ("record", "foreign_embree"):
        output = tmp_path / f"{script}.exr"
        environment = {"HDETENDUE_SAMPLES_PER_PIXEL": "1"}
        arguments = (STAGES / "cornell_box.usda", "/cameras/main", 32, output)
        host.run(script, *arguments, environment=environment)
        pictures.append(read_color(output))
    assert (pictures[0] == pictures[1]).all()
