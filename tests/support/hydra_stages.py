"""Our stages and what the stage reader makes of them, to compare pictures through Hydra with."""

from __future__ import annotations

from pathlib import Path

import etendue
from support.path_order import open_in_path_order
from support.same_picture import Picture, rgb

STAGES = Path(__file__).resolve().parents[2] / "stages"
NAMES = sorted(file.stem for file in STAGES.glob("*.usda"))
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
