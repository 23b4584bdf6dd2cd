"""Our stages through usdrecord and through the stage reader."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from support.hydra_host import SCENE_INDEX, HydraHost
from support.hydra_stages import NAMES, SAMPLES, WIDTH, first_camera, reference, stage_file
from support.same_picture import assert_same_picture, read_color

SCRIPT = "ETENDUE_USDRECORD"  # usdrecord, as OpenUSD has it in pxr/usdImaging/bin


@pytest.mark.parametrize("name", NAMES)
def test_usdrecord(host: HydraHost, tmp_path: Path, name: str) -> None:
    if not os.environ.get(SCRIPT):
        pytest.skip(f"no usdrecord: {SCRIPT} is not set")
    output = tmp_path / "out.exr"
    arguments = ["--disableGpu", "--disableCameraLight", "--renderer", "Etendue"]
    arguments += ["--camera", first_camera(name), "--imageWidth", str(WIDTH)]
    environment = {**SCENE_INDEX, "HDETENDUE_SAMPLES_PER_PIXEL": str(SAMPLES)}
    host.run("usdrecord", *arguments, stage_file(name), output, environment=environment)
    ours = read_color(output)
    assert_same_picture(ours, reference(name, ours))
