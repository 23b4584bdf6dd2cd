"""A stage, ready to be rendered."""

from __future__ import annotations

import warnings
from typing import Unpack

from etendue import _core
from etendue.exceptions import EtendueWarning
from etendue.image import Image
from etendue.inspection import LIGHTS, Inspection, inspect_contents
from etendue.session import Progress, Session
from etendue.settings import INTEGRATORS, RenderOptions, render_settings
from etendue.usd_reader import StageContents, StageLike, StageWarning, read_stage


class Stage:
    """What etendue.open() returns: a USD stage read at one frame."""

    def __init__(self, contents: StageContents) -> None:
        self._contents = contents
        self._spent = False

    def __repr__(self) -> str:
        return f"<etendue.Stage {self.source} at frame {self.frame:g}>"

    @property
    def source(self) -> str:
        """The file, or the root layer's identifier."""
        return self._contents.source

    @property
    def frame(self) -> float:
        """The time code that was read."""
        return self._contents.frame

    @property
    def cameras(self) -> tuple[str, ...]:
        """Prim paths of the cameras that can be rendered from."""
        return self._contents.cameras

    @property
    def warnings(self) -> tuple[StageWarning, ...]:
        """What was left out or replaced, one entry per kind."""
        return self._contents.warnings

    @property
    def scene(self) -> _core.SceneDescription:
        """The scene as the core gets it. Its lists are copies."""
        return self._contents.scene

    def view(
        self, camera: str | None = None, resolution: tuple[int, int] | None = None
    ) -> tuple[str, tuple[int, int]]:
        """The camera's prim path and (width, height) that render() makes of the same arguments.

        Raises SceneError when there is no camera, SettingsError when there is not that one, and for
        a resolution that is none.
        """
        settings = render_settings(self._contents, camera, {"resolution": resolution})
        return self.cameras[settings.camera], (settings.width, settings.height)

    def inspect(self) -> Inspection:
        """What the stage holds and what a render of it needs."""
        return inspect_contents(self._contents)

    def session(
        self,
        camera: str | None = None,
        *,
        progress: Progress | None = None,
        last: bool = False,
        **options: Unpack[RenderOptions],
    ) -> Session:
        """A progressive render, not started yet. Arguments and errors: see render().

        `last`: nothing more is wanted of the stage, whose geometry is let go of before the render
        needs most memory. It cannot be rendered again.
        """
        if self._spent:
            raise _core.SceneError(f"{self.source}: the stage has been given to its last render")
        settings = render_settings(self._contents, camera, options)
        self._require_light(settings)
        metadata = {
            "Software": f"Etendue {_core.__version__}",
            "etendue:version": _core.__version__,
            "etendue:stage": self.source,
            "etendue:frame": f"{self.frame:g}",
            "etendue:camera": self.cameras[settings.camera],
            "etendue:integrator": next(
                name for name, kind in INTEGRATORS.items() if kind == settings.integrator
            ),
            "etendue:seed": str(settings.seed),
        }
        self._spent = last
        return Session(self._contents.scene, settings, metadata, progress, spend_scene=last)

    def render(
        self,
        camera: str | None = None,
        *,
        progress: Progress | None = None,
        **options: Unpack[RenderOptions],
    ) -> Image:
        """Renders and returns the image; `options` are those of RenderOptions.

        `camera` is a prim path, or a prim name that only one camera has; default: that of the
        stage's RenderSettings, else the stage's first. `progress` is called with RenderProgress
        from a render thread.

        Raises SceneError (no camera, no light, unusable scene), SettingsError, FileError (a
        texture), and on Ctrl-C Interrupted, which carries what had been rendered.
        """
        return self.session(camera, progress=progress, **options).run()

    def _require_light(self, settings: _core.RenderSettings) -> None:
        lights = _core.find_requirements(self._contents.scene, settings).lights
        if not any(getattr(lights, kind) for kind in LIGHTS):
            raise _core.SceneError(
                f"{self.source}: the stage has no light and no emitting surface; "
                "its picture would be black"
            )


def open_stage(path_or_stage: StageLike, *, frame: float | None = None) -> Stage:
    """Reads a USD stage (a file, or a Usd.Stage) at a frame; default: its startTimeCode.

    Everything that is not supported is warned about once per kind, as EtendueWarning and in
    Stage.warnings, and the rest is rendered. Raises FileError naming the file when it does not
    exist or is not a stage.
    """
    stage = Stage(read_stage(path_or_stage, frame))
    for warning in stage.warnings:
        warnings.warn(str(warning), EtendueWarning, stacklevel=2)
    return stage
