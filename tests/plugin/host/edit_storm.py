"""Edits a stage at random while it is rendered. In the lulls of the storm, the last of them at its
end, single edits of a finished picture are looked at: through the engine that went through all the
edits, and through a fresh one.

edit_storm.py EDITS SEED FOLDER

Writes these pictures to FOLDER: live_<number>.exr and fresh_<number>.exr. Prints "memory" and the
resident memory, in KiB, after a fifth of the edits and after all.
"""

from __future__ import annotations

import random
import sys
import time
from pathlib import Path

from plugin.host.live_engine import LiveEngine
from plugin.host.storm_edits import StormEdits
from plugin.host.storm_scene import CAMERA, StormScene

SIZE = (48, 32)
SAMPLES_WHILE_EDITING = 100_000
SAMPLES_OF_A_PICTURE = 4
LULLS = 10
EDITS_IN_A_LULL = 5


def resident_memory() -> int:
    """KiB."""
    for line in Path("/proc/self/status").read_text(encoding="ascii").splitlines():
        if line.startswith("VmRSS"):
            return int(line.split()[1])
    raise RuntimeError("no VmRSS")


class Storm:
    """An engine, what it shows, and the edits to come."""

    def __init__(self, seed: int, folder: Path) -> None:
        self._chance = random.Random(seed)
        self._folder = folder
        self._scene = StormScene(self._chance, folder)
        self._edits = StormEdits(self._scene)
        self._engine = self._new_engine()
        self._pictures = 0

    def rage(self, first: int, last: int) -> None:
        """Makes the edits of these numbers, each while the stage is being rendered."""
        self._engine.set(samplesPerPixel=SAMPLES_WHILE_EDITING)
        for number in range(first, last + 1):
            self._edits.make_one()
            if self._engine.step():
                raise RuntimeError(f"nothing was being rendered after edit {number}")
            if self._chance.random() < 0.1:
                time.sleep(self._chance.uniform(0, 0.05))
                self._engine.step()

    def lull(self) -> None:
        """Makes some more edits, and writes both pictures after each."""
        for _ in range(EDITS_IN_A_LULL):
            self._pictures += 1
            live = self._folder / f"live_{self._pictures}.exr"
            self._engine.set(samplesPerPixel=SAMPLES_OF_A_PICTURE, output=str(live))
            self._engine.finish()
            # Settings start a render anew. This must do so alone, and write the picture again.
            self._edits.make_one()
            self._engine.finish()
            fresh = self._new_engine()
            fresh.set(samplesPerPixel=SAMPLES_OF_A_PICTURE)
            fresh.picture(self._folder / f"fresh_{self._pictures}.exr")
        self._engine.set(output="")

    def _new_engine(self) -> LiveEngine:
        return LiveEngine(self._scene.stage, CAMERA, SIZE)


def main(edits: int, seed: int, folder: Path) -> None:
    """See the module."""
    storm = Storm(seed, folder)
    spell = max(edits // LULLS, 1)
    memory = []
    for done in range(spell, edits + 1, spell):
        storm.rage(done - spell + 1, done)
        storm.lull()
        if done in (LULLS // 5 * spell, edits):
            memory.append(resident_memory())
    print("memory", *memory)


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), Path(sys.argv[3]))
