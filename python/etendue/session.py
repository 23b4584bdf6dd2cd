"""Renders in progress."""

from __future__ import annotations

import contextlib
import math
import time
import weakref
from collections.abc import Callable
from types import TracebackType

from etendue import _core
from etendue.exceptions import Interrupted
from etendue.image import Image
from etendue.settings import integrator_text

Progress = Callable[[_core.RenderProgress], object]

# How long Python may be out of reach of a signal, in seconds.
_POLL = 0.1


class Session:
    """One progressive render in the background; any number may run at the same time.

    A context manager that starts the render, and at its end cancels it and waits.
    """

    def __init__(
        self,
        scene: _core.SceneDescription,
        settings: _core.RenderSettings,
        metadata: dict[str, str],
        progress: Progress | None = None,
        *,
        spend_scene: bool = False,
    ) -> None:
        """Builds the scene. Raises SceneError, SettingsError, FileError.

        `spend_scene`: nobody needs the scene any more, which loses its geometries.

        `progress` is called from a render thread; an exception in it cancels the render and is
        raised by wait().
        """
        self._settings = settings
        self._metadata = metadata
        self._core = _core.RenderSession(scene, settings, progress, spend_scene)
        # Also at interpreter exit: no render thread may report to an interpreter that is gone.
        weakref.finalize(self, _stop, self._core)

    def __enter__(self) -> Session:
        self.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        _stop(self._core)

    def start(self) -> None:
        """Returns at once. A second call does nothing."""
        self._core.start()

    def cancel(self) -> None:
        """Asks the render to end soon; what has been rendered stays."""
        self._core.cancel()

    def wait(self, timeout: float | None = None) -> bool:
        """Waits for the end, at most `timeout` seconds; True when rendering has ended.

        A session that was never started counts as ended. Raises what ended the render early.
        Ctrl-C gets through within a tenth of a second and leaves the render running.
        """
        deadline = None if timeout is None else time.monotonic() + timeout
        while True:
            left = _POLL if deadline is None else min(_POLL, deadline - time.monotonic())
            if self._core.wait_for(max(left, 0.0)):
                self._core.wait()
                return True
            if left < _POLL:
                return False

    def run(self, poll: Progress | None = None) -> Image:
        """Starts, waits and returns the image. Ctrl-C raises Interrupted with what there is.

        `poll` is called about ten times a second, and at the end, from the calling thread.
        """
        try:
            self.start()  # in here: Ctrl-C may come before it has returned
            while not self.wait(_POLL):
                if poll:
                    poll(self.progress)
            if poll:
                poll(self.progress)
            return self.snapshot()
        except KeyboardInterrupt:
            raise Interrupted(self._wind_up()) from None
        except BaseException:
            self.cancel()
            raise

    def _wind_up(self) -> Image:
        """Cancels and returns what there is; a Ctrl-C more does not lose it."""
        while True:
            with contextlib.suppress(KeyboardInterrupt):
                self.cancel()
                self.wait()
                return self.snapshot()

    @property
    def pixels(self) -> int:
        """How many pixels a pass renders: those of the crop window, else of the image."""
        window = self._settings.crop
        if window is None:
            return self._settings.width * self._settings.height
        return (window.x1 - window.x0) * (window.y1 - window.y0)

    @property
    def memory_use(self) -> _core.MemoryUse:
        """What its parts hold."""
        return self._core.memory_use

    @property
    def progress(self) -> _core.RenderProgress:
        """How far it is."""
        return self._core.progress

    def snapshot(self) -> Image:
        """The picture so far; usable while rendering."""
        rendered = self._core.snapshot()
        metadata = dict(self._metadata)
        metadata["etendue:spp"] = str(rendered.statistics.passes)
        metadata["etendue:seconds"] = f"{rendered.statistics.seconds:.3f}"
        if math.isfinite(rendered.statistics.error):
            metadata["etendue:error"] = f"{rendered.statistics.error:.4g}"
        if rendered.statistics.chosen is not None:
            metadata["etendue:chosen"] = integrator_text(rendered.statistics.chosen)
        return Image(rendered, metadata)


def _stop(session: _core.RenderSession) -> None:
    session.cancel()
    with contextlib.suppress(Exception):  # whoever cares about failures has called wait()
        session.wait()
