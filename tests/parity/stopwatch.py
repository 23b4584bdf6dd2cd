"""What a piece of work costs."""

from __future__ import annotations

import resource
import time


class Stopwatch:
    """Wall time, and user CPU time of all threads of this process, since it was made."""

    def __init__(self) -> None:
        self._wall = time.perf_counter()
        self._cpu = _user_time()

    @property
    def wall(self) -> float:
        """Seconds."""
        return time.perf_counter() - self._wall

    @property
    def cpu(self) -> float:
        """Seconds."""
        return _user_time() - self._cpu


def _user_time() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_utime
