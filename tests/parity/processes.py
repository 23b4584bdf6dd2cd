"""Renderers in processes of their own: Mitsuba and LuxCore do not bear each other's libraries."""

from __future__ import annotations

import importlib
import multiprocessing
import os
import traceback
from multiprocessing.connection import Connection
from types import TracebackType

from parity.tasks import Picture, Renderer, Task

RENDERERS = {
    "etendue": ("parity.etendue_renderer", "EtendueRenderer"),
    "mitsuba": ("parity.mitsuba_renderer", "MitsubaRenderer"),
    "luxcore": ("parity.luxcore_renderer", "LuxcoreRenderer"),
}


class RendererError(Exception):
    """Carries the other process's traceback."""


class RendererProcess:
    """A renderer with its scene loaded, waiting to be asked. A context manager."""

    def __init__(self, task: Task) -> None:
        self.task = task
        context = multiprocessing.get_context("spawn")
        self._connection, theirs = context.Pipe()
        self._process = context.Process(target=_serve, args=(theirs, task), daemon=True)
        self._process.start()
        theirs.close()

    def __enter__(self) -> RendererProcess:
        self._receive()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._connection.close()
        self._process.join(timeout=10)
        if self._process.is_alive():
            self._process.terminate()

    def render(self, spp: int, seed: int) -> Picture:
        """Raises RendererError."""
        self._connection.send((spp, seed))
        picture = self._receive()
        assert isinstance(picture, Picture)
        return picture

    def _receive(self) -> object:
        try:
            answer = self._connection.recv()
        except EOFError:
            raise RendererError(f"{self.task.method} died") from None
        if isinstance(answer, str):
            raise RendererError(f"{self.task.method}: {answer}")
        return answer


def _serve(connection: Connection, task: Task) -> None:
    """Runs in the other process."""
    _silence()
    try:
        renderer = _make(task)
        connection.send(None)
        while True:
            spp, seed = connection.recv()
            connection.send(renderer.render(spp, seed))
    except EOFError:
        pass
    except Exception:
        connection.send(traceback.format_exc())
    # LuxCore's log handler does not survive the interpreter's end.
    os._exit(0)


def _make(task: Task) -> Renderer:
    module, name = RENDERERS[task.method.renderer]
    renderer: Renderer = getattr(importlib.import_module(module), name)(task)
    return renderer


def _silence() -> None:
    """Progress bars and greetings are of no use to anyone."""
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
