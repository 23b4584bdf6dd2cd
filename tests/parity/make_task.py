"""From a stage to what a renderer is told."""

from __future__ import annotations

from parity.etendue_renderer import camera_index, read_choice
from parity.flatten import flatten
from parity.tasks import Method, StageChoice, Task


def make_task(stage: StageChoice, method: Method, width: int, max_depth: int) -> Task:
    """The image has the camera's aspect; heights are rounded."""
    contents = read_choice(stage)
    camera = camera_index(contents, stage)
    desc = contents.scene.cameras[camera]
    height = round(width * desc.vertical_aperture / desc.horizontal_aperture)
    own = method.renderer == "etendue"
    scene = None if own else flatten(contents.scene, camera, width / height)
    return Task(method, stage, scene, width, height, max_depth)
