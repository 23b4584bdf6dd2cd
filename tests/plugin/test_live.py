"""Edits while a render runs."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from support.hydra_host import SCENE_INDEX, HydraHost
from support.same_picture import read_color

EDITS = 1000
PICTURES = 50  # as in host/edit_storm.py
# A scene is some 100 KiB, with its render buffers: a leak of one per edit would be 80 MiB.
LEAK = 20 * 1024  # KiB


@pytest.mark.parametrize("environment", [{}, SCENE_INDEX], ids=["delegates", "indices"])
def test_a_storm_of_edits_shows_what_a_fresh_engine_shows(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    said = host.run("edit_storm", EDITS, 1, tmp_path, timeout=900, environment=environment)
    live = sorted(tmp_path.glob("live_*.exr"))
    assert len(live) == PICTURES
    for file in live:
        shown = read_color(file)
        np.testing.assert_array_equal(shown, read_color(tmp_path / f"fresh_{file.name[5:]}"))
        assert shown.mean() > 0
    memory = next(line for line in said.splitlines() if line.startswith("memory"))
    early, late = (int(word) for word in memory.split()[1:])
    assert late - early < LEAK
