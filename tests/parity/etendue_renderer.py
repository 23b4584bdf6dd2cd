"""Etendue as one of the renderers."""

from __future__ import annotations

import numpy as np
from pxr import Usd, UsdLux

from etendue import _core
from etendue.stage import Stage
from etendue.usd_reader import StageContents, read_stage
from parity.stopwatch import Stopwatch
from parity.tasks import Picture, StageChoice, Task
from parity.tessellation import sphere_corners


def read_choice(choice: StageChoice) -> StageContents:
    """Reads a stage with its changes made."""
    stage = Usd.Stage.Open(str(choice.file))
    if choice.lamp_radius is not None:
        for prim in stage.Traverse():
            if prim.IsA(UsdLux.SphereLight) or prim.IsA(UsdLux.DiskLight):
                prim.GetAttribute("inputs:radius").Set(choice.lamp_radius)
    if choice.sky is not None:
        for prim in stage.Traverse():
            if prim.IsA(UsdLux.DomeLight):
                prim.GetAttribute("inputs:texture:file").Set(str(choice.sky))
    contents = read_stage(stage)
    if choice.tessellated:
        _tessellate(contents.scene)
    return contents


def camera_index(contents: StageContents, choice: StageChoice) -> int:
    """Of the chosen camera, in the scene description."""
    camera = choice.camera or contents.settings.camera
    return contents.cameras.index(camera) if camera else 0


class EtendueRenderer:
    """A session for every picture."""

    def __init__(self, task: Task) -> None:
        assert task.stage is not None
        self._task = task
        self._camera = task.stage.camera
        self._stage = Stage(read_choice(task.stage))

    def render(self, spp: int, seed: int) -> Picture:
        """The clock runs while the session does; the scene is built before."""
        task = self._task
        session = self._stage.session(
            self._camera,
            resolution=(task.width, task.height),
            integrator=task.method.integrator,
            spp=spp,
            seed=seed,
            max_depth=task.max_depth,
            threads=task.threads,
            aovs=("color",),
        )
        clock = Stopwatch()
        image = session.run()
        wall, cpu = clock.wall, clock.cpu
        if any(image.statistics.invalid.values()):
            raise ArithmeticError(
                f"{self._stage.source}: invalid samples {image.statistics.invalid}"
            )
        return Picture(image.color.astype(np.float64), wall, cpu)


def _tessellate(scene: _core.SceneDescription) -> None:
    geometries = scene.geometries
    for index, geometry in enumerate(geometries):
        if isinstance(geometry, _core.SphereDesc):
            corners = sphere_corners(128, 64) * geometry.radius
            geometries[index] = _core.MeshDesc(
                points=corners.reshape(-1, 3),
                face_vertex_counts=np.full(len(corners), 3),
                face_vertex_indices=np.arange(3 * len(corners)),
            )
    scene.geometries = geometries
