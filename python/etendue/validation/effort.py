"""How much work a run of the suite is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeVar

_T = TypeVar("_T")


@dataclass(frozen=True)
class Effort:
    """Samples of every render are multiplied by `scale`; `full` asks for finer sweeps, too."""

    name: str
    scale: float
    takes: int
    """Independent renders behind every interval."""
    full: bool

    def spp(self, samples: int) -> int:
        return max(1, round(self.scale * samples))

    def picture_spp(self, samples: int) -> int:
        """Of a picture that is looked at: it grows with its size, too."""
        return self.pick(samples, 2 * samples)

    def pick(self, quick: _T, full: _T) -> _T:
        return full if self.full else quick

    def size(self, width: int, height: int) -> tuple[int, int]:
        """Of a picture that is looked at: three eighths of it each way when quick."""
        return self.pick((width * 3 // 8, height * 3 // 8), (width, height))


QUICK = Effort("quick", 1.0, 16, full=False)
FULL = Effort("full", 4.0, 16, full=True)
EFFORTS: Sequence[Effort] = (QUICK, FULL)
