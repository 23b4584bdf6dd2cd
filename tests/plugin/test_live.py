"""Edits while a render runs."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from support.hydra_host import SCENE_INDEX, HydraHost
from support.same_picture import read_color

EDITS = 1000
# A scene is some 100 KiB, with its render buffers: a leak of one per edit would be 80 MiB.
LEAK = 20 * 1024  # KiB


@pytest.mark.parametrize("environment", [{}, SCENE_INDEX], ids=["delegates", "indices"])
def test_a_storm_of_edits_ends_with_the_picture_of_its_end(
    host: HydraHost, tmp_path: Path, environment: dict[str, str]
) -> None:
    after, fresh = tmp_path / "after.exr", tmp_path / "fresh.exr"
    said = host.run("edit_storm", EDITS, 1, after, fresh, timeout=900, environment=environment)
    np.testing.assert_array_equal(read_color(after), read_color(fresh))
    assert read_color(after).mean() > 0
    memory = next(line for line in said.splitlines() if line.startswith("memory"))
    early, late = (int(word) for word in memory.split()[1:])
    assert late - early < LEAK
