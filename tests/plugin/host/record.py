"""Renders a stage through FrameRecorder, without a graphics card.

record.py STAGE CAMERA WIDTH OUTPUT [PURPOSE...]

Without purposes: default and render.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence

from pxr import Usd, UsdAppUtils, UsdGeom

from plugin.host.names import RENDERER


def record(
    stage_file: str, camera: str, width: int, output: str, purposes: Sequence[str] = ()
) -> None:
    """Writes the colour to `output`, an .exr."""
    stage = Usd.Stage.Open(stage_file)
    recorder = UsdAppUtils.FrameRecorder(RENDERER, False)
    recorder.SetImageWidth(width)
    recorder.SetCameraLightEnabled(False)
    recorder.SetIncludedPurposes(list(purposes) or ["default", "render"])
    settings = stage.GetMetadata("renderSettingsPrimPath")
    if settings:  # usdrecord does so, too
        recorder.SetActiveRenderSettingsPrimPath(settings)
    time = Usd.TimeCode(stage.GetStartTimeCode())
    if not recorder.Record(stage, UsdGeom.Camera.Get(stage, camera), time, output):
        sys.exit(f"{stage_file} was not recorded")


if __name__ == "__main__":
    record(sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4], sys.argv[5:])
