"""Progress on the terminal, of a render or of several steps: a bar, or plain lines where there is
none."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from math import isfinite
from types import TracebackType
from typing import Protocol

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

from etendue import _core

# Seconds between lines when the output is no terminal.
_LINE_INTERVAL = 5.0

StepProgress = Callable[[str, int, int], object]
"""(step about to be made, how many have been made, how many there are)"""


class ProgressDisplay(Protocol):
    """A context manager that is called while the render runs and once at its end."""

    def __enter__(self) -> ProgressDisplay: ...
    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None: ...
    def __call__(self, progress: _core.RenderProgress) -> None: ...


def progress_display(console: Console, pixels: int) -> ProgressDisplay:
    """What suits the console; `pixels` is the number of pixels a pass renders."""
    return _Bar(console, pixels) if console.is_terminal else _Lines(console, pixels)


def describe(progress: _core.RenderProgress, pixels: int) -> str:
    """Samples, error, rate and time left, on one line."""
    total = f"/{progress.passes_total}" if progress.passes_total else ""
    parts = [f"{progress.passes_done}{total} spp"]
    if isfinite(progress.error):
        parts.append(error_text(progress.error))
    if progress.seconds > 0 and progress.passes_done:
        rate = progress.passes_done * pixels / progress.seconds
        parts.append(f"{rate / 1e6:.2f} Mpaths/s")
    if progress.finished:
        parts.append(f"done in {duration(progress.seconds)}")
    elif progress.fraction > 0:
        left = progress.seconds * (1 - progress.fraction) / progress.fraction
        parts.append(f"{duration(left)} left")
    return ", ".join(parts)


def error_text(error: float) -> str:
    """Of RenderStatistics.error: 'error 5.12%'."""
    return f"error {100 * error:.3g}%"


def duration(seconds: float) -> str:
    """1:02:03, 2:03 or 3.4 s."""
    if seconds < 60:
        return f"{seconds:.1f} s"
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"


@contextmanager
def step_progress(doing: str) -> Iterator[StepProgress]:
    """On stderr: a bar on a terminal, a line per step elsewhere."""
    console = Console(file=sys.stderr, highlight=False)
    if not console.is_terminal:
        yield lambda name, done, total: console.print(f"{doing} {done + 1}/{total}: {name}")
        return
    with Progress(
        TextColumn(doing),
        BarColumn(),
        TextColumn("{task.description}"),
        TimeElapsedColumn(),
        console=console,
        transient=True,
    ) as bar:
        task = bar.add_task("", total=None)
        yield lambda name, done, total: bar.update(
            task, completed=done, total=total, description=name
        )


class _Bar:
    def __init__(self, console: Console, pixels: int) -> None:
        self._pixels = pixels
        self._bar = Progress(
            TextColumn("rendering"), BarColumn(), TextColumn("{task.description}"), console=console
        )
        self._task = self._bar.add_task("", total=1.0)

    def __enter__(self) -> _Bar:
        self._bar.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self._bar.stop()

    def __call__(self, progress: _core.RenderProgress) -> None:
        self._bar.update(
            self._task,
            completed=progress.fraction,
            description=describe(progress, self._pixels),
        )


class _Lines:
    def __init__(self, console: Console, pixels: int) -> None:
        self._console = console
        self._pixels = pixels
        self._next = time.monotonic()

    def __enter__(self) -> _Lines:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        pass

    def __call__(self, progress: _core.RenderProgress) -> None:
        now = time.monotonic()
        if now < self._next and not progress.finished:
            return
        self._next = now + _LINE_INTERVAL
        line = f"rendering: {describe(progress, self._pixels)}"
        self._console.print(line, markup=False, highlight=False, soft_wrap=True)
