"""What a host can do with a render besides waiting for it.

behaviour.py STAGE FOLDER

Writes the edited stage's picture of a crop to FOLDER and prints, as JSON, numbers of passes: before
and after half a second of pause, and half a second after the pause.
"""

from __future__ import annotations

import json
import random
import sys
import time
from pathlib import Path

from plugin.host.live_engine import LiveEngine
from plugin.host.storm_scene import CAMERA, StormScene

SIZE = (48, 32)
CROP = (12, 4, 20, 16)  # x, y, width, height
ENDLESS = 1_000_000
SAMPLES = 4


def passes(engine: LiveEngine) -> int:
    """Complete ones."""
    return int(str(engine.stats["numCompletedSamples"]))


def wait_for_passes(engine: LiveEngine) -> None:
    """Until something has been rendered."""
    end = time.monotonic() + 60
    while passes(engine) == 0:
        engine.step()
        if time.monotonic() > end:
            raise TimeoutError("nothing is rendered")


def pause_and_resume(engine: LiveEngine) -> dict[str, int]:
    """Numbers of passes."""
    wait_for_passes(engine)
    engine.engine.PauseRenderer()
    time.sleep(0.2)  # for the tiles that were begun
    before = passes(engine)
    time.sleep(0.5)
    after = passes(engine)
    engine.engine.ResumeRenderer()
    time.sleep(0.5)
    return {"before": before, "after": after, "resumed": passes(engine)}


def stop_and_restart(engine: LiveEngine) -> dict[str, bool]:
    """Whether the picture is finished once stopped, and is not once restarted."""
    engine.engine.StopRenderer()
    stopped = engine.step()
    engine.engine.RestartRenderer()
    return {"stopped": stopped, "restarted": not engine.step()}


def main(stage: Path, folder: Path) -> None:
    """See the module."""
    scene = StormScene(random.Random(3), folder)
    scene.stage.GetRootLayer().Export(str(stage))
    engine = LiveEngine(scene.stage, CAMERA, SIZE)
    engine.set(samplesPerPixel=ENDLESS)
    engine.step()
    told: dict[str, object] = {**pause_and_resume(engine), **stop_and_restart(engine)}
    cropped = LiveEngine(scene.stage, CAMERA, SIZE, CROP)
    cropped.set(samplesPerPixel=SAMPLES)
    cropped.picture(folder / "crop.exr")
    told["percent"] = cropped.stats["percentDone"]
    print(json.dumps(told))
    # `engine` still renders: it is taken down in the middle of it.


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
